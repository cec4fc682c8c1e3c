// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/emulator/link/link.h"

#include <algorithm>

namespace cbvh::emulator {

namespace {

using Bytes = std::vector<std::uint8_t>;
using Milliseconds = std::chrono::milliseconds;

/// How long a piece that others overtake waits for one that does.
constexpr Milliseconds kOvertaking{20};

bool can_happen(FaultKind kind, Direction direction) {
  return direction == Direction::in || (kind != FaultKind::short_ && kind != FaultKind::babble);
}

Milliseconds between(vectors::Random& random, int low, int high) { return Milliseconds(random.between(low, high)); }

/// Cuts a random piece out; in half of all cases that is everything.
void drop(Bytes& bytes, vectors::Random& random) {
  if (random.flip()) return bytes.clear();
  const auto begin = static_cast<std::ptrdiff_t>(random.below(bytes.size()));
  const auto length = 1 + static_cast<std::ptrdiff_t>(random.below(bytes.size() - static_cast<std::size_t>(begin)));
  bytes.erase(bytes.begin() + begin, bytes.begin() + begin + length);
}

void corrupt(Bytes& bytes, vectors::Random& random) {
  for (int count = random.between(1, 4); count > 0; --count) {
    std::uint8_t& byte = bytes[random.below(bytes.size())];
    byte = static_cast<std::uint8_t>(byte ^ random.between(1, 255));
  }
}

}  // namespace

Link::Link(Core& core, std::vector<Fault> faults, std::uint64_t seed)
    : core_(core), faults_(std::move(faults)), random_(seed), seed_(seed) {}

std::optional<FaultKind> Link::draw(Direction direction) {
  random_ = vectors::Random(vectors::mix(seed_ * 2 + index(direction), transfers_[index(direction)]++));
  for (const Fault& fault : faults_) {
    if (!can_happen(fault.kind, direction) || static_cast<double>(random_.unit()) >= fault.rate) continue;
    ++happened_[fault.kind];
    return fault.kind;
  }
  return std::nullopt;
}

bool Link::waits(Direction direction, Time now) {
  std::optional<Time>& until = waits_until_[index(direction)];
  if (!until) return false;
  if (now < *until) return true;
  until.reset();
  excused_[index(direction)] = true;
  return false;
}

std::optional<Transfer> Link::interrupt(FaultKind kind, Direction direction, Time now) {
  switch (kind) {
    case FaultKind::stall:
      halted_[index(direction)] = true;
      return Transfer{Transfer::Status::stalled};
    case FaultKind::nak:
      waits_until_[index(direction)] = now + between(random_, 30, 400);
      break;
    case FaultKind::delay:
      waits_until_[index(direction)] = now + between(random_, 1, 8);
      break;
    case FaultKind::disconnect:
      plug_ = Plug::leaves;
      break;
    case FaultKind::reconnect:
      plug_ = Plug::leaves_and_returns;
      break;
    case FaultKind::reset:
      power_on();
      excused_[index(direction)] = true;
      break;
    default:
      return std::nullopt;
  }
  return Transfer{Transfer::Status::pending};
}

void Link::deliver(std::span<const std::uint8_t> bytes) {
  if (!bytes.empty()) core_.receive(bytes);
}

void Link::release_out(Time now) {
  std::optional<Held>& held = held_[index(Direction::out)];
  if (held && now >= held->until) deliver(std::exchange(held, std::nullopt)->bytes);
}

std::vector<Bytes> Link::mangle(FaultKind kind, Bytes bytes) {
  switch (kind) {
    case FaultKind::corrupt:
      corrupt(bytes, random_);
      break;
    case FaultKind::drop:
      drop(bytes, random_);
      break;
    case FaultKind::duplicate:
      return {bytes, bytes};
    default:
      break;
  }
  return {std::move(bytes)};
}

Transfer Link::out(std::span<const std::uint8_t> bytes, Time now) {
  constexpr Direction kOut = Direction::out;
  release_out(now);
  if (halted_[index(kOut)]) return {Transfer::Status::stalled};
  if (waits(kOut, now)) return {Transfer::Status::pending};
  const bool excused = std::exchange(excused_[index(kOut)], false);
  const std::optional<FaultKind> fault = excused || bytes.empty() ? std::nullopt : draw(kOut);
  if (fault) {
    if (auto interrupted = interrupt(*fault, kOut, now)) return *interrupted;
  }
  const std::optional<Held> overtaken = std::exchange(held_[index(kOut)], std::nullopt);
  if (!fault) {
    deliver(bytes);
  } else if (*fault == FaultKind::reorder) {
    held_[index(kOut)] = Held{Bytes(bytes.begin(), bytes.end()), now + kOvertaking};
  } else {
    for (const Bytes& piece : mangle(*fault, Bytes(bytes.begin(), bytes.end()))) deliver(piece);
  }
  if (overtaken) deliver(overtaken->bytes);
  return {};
}

void Link::put_back(std::span<const std::uint8_t> bytes) {
  if (!bytes.empty()) in_queue_.emplace_front(bytes.begin(), bytes.end());
}

Bytes Link::next_in(std::size_t most, Time now) {
  if (in_queue_.empty()) {
    Bytes bytes = core_.send(most);
    std::optional<Held>& held = held_[index(Direction::in)];
    if (!held || (bytes.empty() && now < held->until)) return bytes;
    put_back(std::exchange(held, std::nullopt)->bytes);
    if (!bytes.empty()) return bytes;
  }
  Bytes bytes = std::move(in_queue_.front());
  in_queue_.pop_front();
  if (bytes.size() > most) {
    put_back(std::span(bytes).subspan(most));
    bytes.resize(most);
  }
  return bytes;
}

Transfer Link::in(std::size_t most, Time now) {
  constexpr Direction kIn = Direction::in;
  release_out(now);
  if (halted_[index(kIn)]) return {Transfer::Status::stalled};
  if (waits(kIn, now) || most == 0) return {Transfer::Status::pending};
  Bytes bytes = next_in(most, now);
  if (bytes.empty()) return {Transfer::Status::pending};
  const std::optional<FaultKind> fault = std::exchange(excused_[index(kIn)], false) ? std::nullopt : draw(kIn);
  if (!fault) return {Transfer::Status::done, std::move(bytes)};
  if (*fault == FaultKind::babble) return {Transfer::Status::babbled};
  if (*fault == FaultKind::reorder && !held_[index(kIn)]) {
    held_[index(kIn)] = Held{std::move(bytes), now + kOvertaking};
    return {Transfer::Status::pending};
  }
  if (*fault == FaultKind::short_) {
    const std::size_t kept = bytes.size() > 1 ? random_.below(bytes.size()) : 1;
    put_back(std::span(bytes).subspan(kept));
    bytes.resize(kept);
    return {Transfer::Status::done, std::move(bytes)};
  }
  std::vector<Bytes> pieces = mangle(*fault, bytes);
  put_back(bytes);
  if (auto interrupted = interrupt(*fault, kIn, now)) return *interrupted;
  in_queue_.pop_front();
  for (std::size_t i = pieces.size(); i > 1; --i) put_back(pieces[i - 1]);
  if (pieces[0].empty()) return {Transfer::Status::pending};
  return {Transfer::Status::done, std::move(pieces[0])};
}

std::optional<Time> Link::wake() const {
  std::optional<Time> first;
  const auto add = [&first](const std::optional<Time>& time) {
    if (time && (!first || *time < *first)) first = time;
  };
  for (const auto& until : waits_until_) add(until);
  for (const auto& held : held_) {
    if (held) add(held->until);
  }
  return first;
}

void Link::power_on() {
  core_.reset();
  halted_ = {};
  waits_until_ = {};
  excused_ = {};
  held_ = {};
  in_queue_.clear();
}

}  // namespace cbvh::emulator
