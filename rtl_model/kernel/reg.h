// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/kernel/commit_key.h"

namespace cbvh::rtl {

/// A register: `q` is what it holds in this cycle, `set` what it will hold in the next.
template <class T>
class Reg {
 public:
  Reg() = default;
  explicit Reg(T reset) : q_(reset), d_(reset) {}
  Reg(const Reg&) = delete;
  Reg& operator=(const Reg&) = delete;

  const T& q() const { return q_; }
  void set(const T& next) { d_ = next; }
  void commit(CommitKey) { q_ = d_; }

 private:
  T q_{};
  T d_{};
};

}  // namespace cbvh::rtl
