// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/update/async_rebuild.h"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace cbvh::golden {

struct AsyncRebuild::Shared {
  enum class State { idle, building, finished };

  explicit Shared(const Builder& with) : builder(with) {}

  void run() {
    std::unique_lock lock(mutex);
    while (true) {
      changed.wait(lock, [this] { return closing || state == State::building; });
      if (closing) return;
      lock.unlock();
      FloatTree built;
      std::exception_ptr thrown;
      try {
        built = builder.build(*mesh);
      } catch (...) {
        thrown = std::current_exception();
      }
      lock.lock();
      tree = std::move(built);
      failure = thrown;
      state = State::finished;
      changed.notify_all();
    }
  }

  const Builder builder;
  std::mutex mutex;  ///< of what follows; the builder reads `mesh` without it, nobody writes that meanwhile
  std::condition_variable changed;
  State state = State::idle;
  bool closing = false;
  std::shared_ptr<const Mesh> mesh;
  FloatTree tree;
  std::exception_ptr failure;
  std::jthread thread{[this] { run(); }};
};

AsyncRebuild::AsyncRebuild(const Builder& builder) : shared_(std::make_unique<Shared>(builder)) {}

AsyncRebuild::~AsyncRebuild() {
  {
    const std::lock_guard lock(shared_->mutex);
    shared_->closing = true;
  }
  shared_->changed.notify_all();
}

void AsyncRebuild::start(std::shared_ptr<const Mesh> mesh) {
  {
    const std::lock_guard lock(shared_->mutex);
    shared_->mesh = std::move(mesh);
    shared_->state = Shared::State::building;
  }
  shared_->changed.notify_all();
}

std::optional<FloatTree> AsyncRebuild::take() {
  const std::lock_guard lock(shared_->mutex);
  if (shared_->state != Shared::State::finished) return std::nullopt;
  shared_->state = Shared::State::idle;
  if (shared_->failure) std::rethrow_exception(std::exchange(shared_->failure, nullptr));
  return std::move(shared_->tree);
}

bool AsyncRebuild::idle() const {
  const std::lock_guard lock(shared_->mutex);
  return shared_->state == Shared::State::idle;
}

void AsyncRebuild::wait() const {
  std::unique_lock lock(shared_->mutex);
  shared_->changed.wait(lock, [this] { return shared_->state != Shared::State::building; });
}

}  // namespace cbvh::golden
