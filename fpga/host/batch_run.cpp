// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/host/batch_run.h"

#include <algorithm>
#include <utility>

namespace cbvh::host {

BatchRun::BatchRun(Session& session, const vectors::VectorSet& set, const RunLimits& limits, ResponseSink& sink)
    : session_(session),
      link_(session.link_),
      set_(set),
      wanted_{&set.unit(), set.parameters()},
      limits_(limits),
      sink_(sink),
      plan_(plan_batches(set, session.board_, session.device())),
      states_(plan_.size()),
      first_number_(session.next_batch_) {
  session_.next_batch_ += static_cast<std::uint32_t>(plan_.size());
  for (std::size_t i = 0; i < plan_.size(); ++i) to_send_.push_back(i);
}

void BatchRun::complete() {
  bool prepared = false;
  std::optional<LinkError> error;
  while (batches_done_ < plan_.size()) {
    try {
      if (const auto before = std::exchange(error, std::nullopt)) repair(*before);
      if (!std::exchange(prepared, true)) session_.prepare(wanted_);
      step();
    } catch (const LinkError& found) {
      if (given_up_ || !may_pass(found.fault())) throw;
      error = found;
    }
  }
}

void BatchRun::step() {
  send_batches();
  if (sent_.empty()) probe();  // there is something to send, but no credit
  if (const auto frame = link_.receive(deadline_)) {
    handle(*frame);
    if (link_.has_gap() && awaits_batch()) probe();
  } else {
    silence();
  }
}

void BatchRun::send_batches() {
  while (!to_send_.empty() && link_.has_credit()) {
    const std::size_t batch = to_send_.front();
    to_send_.pop_front();
    if (!states_[batch].done) send_batch(batch);
  }
}

void BatchRun::send_batch(std::size_t batch) {
  Bytes frame = begin_frame(batch_bytes(set_, plan_[batch]));
  append_batch(frame, set_, plan_[batch], first_number_ + static_cast<std::uint32_t>(batch), limits_);
  if (!awaits_batch()) deadline_ = link_.deadline();
  probes_ = 0;
  ++session_.counters_.batches;
  if (states_[batch].lost > 0) ++session_.counters_.resent;
  sent_.push_back({link_.next_sequence(), batch});
  link_.send_in_place(FrameType::vectors, std::move(frame));
}

/// Asks for the board's status, unless such a question is under way.
void BatchRun::probe() {
  const bool asked = std::any_of(sent_.begin(), sent_.end(), [](const Sent& sent) { return sent.batch == kProbe; });
  if (asked) return;
  ++session_.counters_.probes;
  sent_.push_back({link_.next_sequence(), kProbe});
  link_.send(FrameType::status);
  deadline_ = link_.deadline();
}

void BatchRun::silence() {
  if (probes_ == session_.options_.tries) {
    link_.fail(LinkFault::timeout, fmt::format("no answer to STATUS, {} times", probes_));
  }
  ++probes_;
  std::erase_if(sent_, [](const Sent& sent) { return sent.batch == kProbe; });
  probe();
}

void BatchRun::note_recovery(const std::string& why) {
  if (++recoveries_ <= session_.options_.recoveries) return;
  given_up_ = true;
  link_.fail(LinkFault::timeout, fmt::format("{}, and {} resets have not helped: check cable and power", why,
                                             session_.options_.recoveries));
}

void BatchRun::recover() {
  ++session_.counters_.recoveries;
  for (auto sent = sent_.rbegin(); sent != sent_.rend(); ++sent) {
    if (sent->batch == kProbe || states_[sent->batch].done) continue;
    ++states_[sent->batch].lost;
    to_send_.push_front(sent->batch);
  }
  sent_.clear();
  probes_ = 0;
  session_.recover(wanted_);
  deadline_ = link_.deadline();
}

/// Brings the link back after an error that may pass.
void BatchRun::repair(const LinkError& error) {
  if (error.fault() == LinkFault::gone) {
    note_recovery("it went and came back");
    if (!link_.transport().reconnect(session_.options_.reconnect_timeout)) {
      given_up_ = true;
      throw error;
    }
    ++session_.counters_.reconnects;
  } else {
    note_recovery(error.message());
  }
  recover();
}

bool BatchRun::awaits_batch() const {
  return std::any_of(sent_.begin(), sent_.end(), [](const Sent& sent) { return sent.batch != kProbe; });
}

void BatchRun::handle(const Link::Frame& frame) {
  switch (frame.type) {
    case FrameType::results:
      return handle_results(frame.payload);
    case FrameType::board_status:
      return handle_status();
    case FrameType::error:
      return handle_error(frame.payload);
    default:
      return;
  }
}

void BatchRun::handle_results(ByteSpan payload) {
  const auto results = BatchResults::parse(payload, set_.response_codec().packed_bytes());
  if (!results) link_.fail(LinkFault::refused, "RESULTS has a wrong length: load the gateware of this version");
  const std::uint32_t batch = results->number - first_number_;
  if (batch >= plan_.size()) return;
  const auto position = std::find_if(sent_.begin(), sent_.end(), [&](const Sent& sent) { return sent.batch == batch; });
  if (position != sent_.end()) answered(static_cast<std::size_t>(position - sent_.begin()));
  State& state = states_[batch];
  if (state.done) return;
  if (!fits(*results, set_, plan_[batch])) {
    link_.fail(LinkFault::refused,
               fmt::format("RESULTS of batch {} are not those of its cases: load the gateware of this "
                           "version",
                           results->number));
  }
  state.done = true;
  if (batch == delivered_) {
    deliver(*results, set_, plan_[batch], sink_);
    ++delivered_;
  } else {
    state.results.assign(payload.begin(), payload.end());
  }
  ++batches_done_;
  cases_done_ += plan_[batch].cases;
  session_.counters_.cases_done += plan_[batch].cases;
  cycles_ += results->cycles;
  recoveries_ = 0;
  probes_ = 0;
  deadline_ = link_.deadline();
  deliver_in_order();
}

void BatchRun::handle_status() {
  const auto position = std::find_if(sent_.begin(), sent_.end(), [](const Sent& sent) { return sent.batch == kProbe; });
  if (position == sent_.end()) return;
  answered(static_cast<std::size_t>(position - sent_.begin()));
}

void BatchRun::handle_error(ByteSpan payload) {
  const auto error = BoardError::parse(payload);
  if (!error) return;
  session_.check_error(payload);
  if (error->reason == ErrorReason::not_open) {  // it was reset by something else
    link_.fail(LinkFault::timeout, "the board loses its open unit");
  }
  const auto position =
      std::find_if(sent_.begin(), sent_.end(), [&](const Sent& sent) { return sent.sequence == error->sequence; });
  if (position == sent_.end()) return;
  const std::size_t batch = position->batch;
  answered(static_cast<std::size_t>(position - sent_.begin()));
  if (batch == kProbe || states_[batch].done) return;
  if (states_[batch].lost >= session_.options_.resends) {
    link_.fail(LinkFault::refused,
               fmt::format("refused a batch {} times: {}", states_[batch].lost + 1, describe(*error)));
  }
  send_again(batch);
}

void BatchRun::answered(std::size_t position) {
  std::vector<std::size_t> lost;
  for (std::size_t i = 0; i < position; ++i) {
    if (sent_[i].batch != kProbe) lost.push_back(sent_[i].batch);
  }
  sent_.erase(sent_.begin(), sent_.begin() + static_cast<std::ptrdiff_t>(position) + 1);
  for (auto batch = lost.rbegin(); batch != lost.rend(); ++batch) send_again(*batch);
}

void BatchRun::send_again(std::size_t batch) {
  State& state = states_[batch];
  if (state.done) return;
  if (++state.lost > session_.options_.resends) {
    given_up_ = true;
    link_.fail(LinkFault::timeout, fmt::format("a batch was sent {} times and never answered: check cable and power",
                                               session_.options_.resends + 1));
  }
  to_send_.push_front(batch);
}

void BatchRun::deliver_in_order() {
  for (; delivered_ < plan_.size() && states_[delivered_].done; ++delivered_) {
    const Bytes payload = std::exchange(states_[delivered_].results, {});
    const auto results = BatchResults::parse(payload, set_.response_codec().packed_bytes());
    deliver(*results, set_, plan_[delivered_], sink_);
  }
}

}  // namespace cbvh::host
