// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "testbench/backend/responses.h"
#include "testbench/backend/run_options.h"
#include "vectors/vector_set.h"

namespace cbvh::testbench {

/// Whoever takes stimuli and gives responses: the golden, the C++ modules, the gateware, a board.
class Backend {
 public:
  virtual ~Backend() = default;

  virtual std::string name() const = 0;
  /// Whether it has this unit's face.
  virtual bool has(const vectors::UnitDescription& unit) const = 0;
  /// Whether it has the face with these parameters.
  virtual bool takes(const vectors::UnitDescription& unit, const vectors::Parameters& parameters) const {
    static_cast<void>(parameters);
    return has(unit);
  }
  /// Empty, or why it cannot run here and now: the command then exits 77.
  virtual std::string why_unavailable() const { return {}; }
  /// Whether its channels can be made to stall, and its modules be evaluated in another order.
  virtual bool stalls() const { return true; }
  virtual bool shuffles() const { return false; }
  /// Whether it counts the corners of the model (rtl_model/bits/corner.h) that its runs take.
  virtual bool observes_corners() const { return false; }
  /// Runs every case of the set. May be called by several threads at once.
  virtual Responses run(const vectors::VectorSet& set, const RunOptions& options) const = 0;
};

/// Makes one backend. backends/x.cpp defines make_x_backend and needs no entry anywhere.
using MakeBackend = std::unique_ptr<Backend>();
std::vector<MakeBackend*> all_backends();

/// Throws InputError naming the backends when there is none of this name, Unavailable when it cannot run.
std::unique_ptr<Backend> make_backend(const std::string& name);
std::vector<std::string> backend_names();
/// Throws Unavailable, naming the units it has, when the backend lacks one of this name.
void require_unit(const Backend& backend, const vectors::UnitDescription& unit);
/// The same for parameters of a unit that it has.
void require_parameters(const Backend& backend, const vectors::VectorSet& set);

}  // namespace cbvh::testbench
