// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/backend/backend.h"
#include "testbench/rtl/unit_driver.h"

namespace cbvh::testbench {

namespace {

/// The C++ modules, clock by clock.
class RtlBackend final : public Backend {
 public:
  std::string name() const override { return "rtl"; }
  bool has(const vectors::UnitDescription& unit) const override { return find(unit) != nullptr; }
  bool shuffles() const override { return true; }
  bool observes_corners() const override { return true; }

  Responses run(const vectors::VectorSet& set, const RunOptions& options) const override {
    const UnitDriver* driver = find(set.unit());
    if (driver == nullptr) throw golden::InputError("--backend", fmt::format("rtl has no unit '{}'", set.unit().name));
    return driver->run(set, options);
  }

 private:
  const UnitDriver* find(const vectors::UnitDescription& unit) const {
    for (const UnitDriver& driver : drivers_) {
      if (driver.unit == unit.name) return &driver;
    }
    return nullptr;
  }

  const std::vector<UnitDriver> drivers_ = all_unit_drivers();
};

}  // namespace

std::unique_ptr<Backend> make_rtl_backend() { return std::make_unique<RtlBackend>(); }

}  // namespace cbvh::testbench
