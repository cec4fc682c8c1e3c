// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "testbench/board/bench.h"
#include "testbench/board/connection.h"
#include "testbench/board/selftest.h"
#include "testbench/command_line.h"
#include "testbench/output.h"
#include "testbench/report/print.h"
#include "testbench/unavailable.h"

namespace cbvh::testbench {

namespace {

struct Options {
  BoardSelftest selftest;
  BoardBench bench;
  Output output;
};

int list(const Options& options) {
  const std::string reason = host::why_no_usb();
  if (!reason.empty()) throw Unavailable(reason);
  Json boards = Json::array();
  std::string text;
  for (const host::BoardInfo& board : host::list_boards()) {
    const bool taken = board.kind == host::BoardKind::bulk || board.ours();
    text += fmt::format("{} ({}, {}){}{}\n", board.device(), host::to_string(board.kind), board.speed,
                        taken ? "" : ": not named 'cbvh...', taken only by --device",
                        board.problem.empty() ? "" : ": " + board.problem);
    boards.push_back({{"device", board.device()},
                      {"address", fmt::format("{}:{}", board.bus, board.address)},
                      {"id", fmt::format("{:04x}:{:04x}", board.vendor, board.product)},
                      {"product", board.product_name},
                      {"serial", board.serial},
                      {"kind", host::to_string(board.kind)},
                      {"speed", board.speed},
                      {"taken", taken},
                      {"problem", board.problem}});
  }
  options.output.text(boards.empty() ? "no board is plugged in\n" : text);
  options.output.json({{"boards", boards}});
  return boards.empty() ? kSkipped : kPass;
}

std::string set_of(unsigned mask) {
  std::vector<int> values;
  for (int i = 0; i < 16; ++i) {
    if ((mask >> i & 1) != 0) values.push_back(i);
  }
  return fmt::format("{}", fmt::join(values, " "));
}

int info(const Options& options) {
  host::Session& session = BoardConnection::instance().session();
  const host::BoardHello& board = session.board();
  const host::BoardStatus status = session.status();
  std::string text = fmt::format(
      "device             {}\nname               {}\nfirmware           {}.{}\nclock              {} MHz\n"
      "batch buffers      {}\ngreatest payload   {} bytes to the board, {} from it\n",
      session.device(), board.name, board.firmware_version >> 8, board.firmware_version & 0xFF,
      board.clock_khz / 1000.0, board.buffers, board.greatest_payload_in, board.greatest_payload_out);
  Json units = Json::array();
  for (const host::OfferedUnit& unit : board.units) {
    text += fmt::format("unit               {:<28} N = {}; D = {}{}\n", unit.name, set_of(unit.bits_mask),
                        set_of(unit.treelet_mask), unit.stateful ? "; has state" : "");
    units.push_back({{"name", unit.name},
                     {"bits_mask", unit.bits_mask},
                     {"treelet_mask", unit.treelet_mask},
                     {"stateful", unit.stateful}});
  }
  text += fmt::format("since the reset    {} frames, {} bytes skipped, {} corrupted, {} lost, {} stale\n", status.taken,
                      status.skipped, status.corrupted, status.lost, status.stale);
  options.output.text(text);
  options.output.json({{"device", session.device()},
                       {"name", board.name},
                       {"firmware", board.firmware_version},
                       {"clock_khz", board.clock_khz},
                       {"buffers", board.buffers},
                       {"greatest_payload_in", board.greatest_payload_in},
                       {"greatest_payload_out", board.greatest_payload_out},
                       {"units", units},
                       {"frames", status.taken},
                       {"skipped", status.skipped},
                       {"corrupted", status.corrupted},
                       {"lost", status.lost},
                       {"stale", status.stale}});
  return kPass;
}

int selftest(const Options& options) {
  const Report report = selftest_board(options.selftest);
  options.output.text(to_string(report));
  options.output.json(to_json(report));
  return judge(report).pass() ? kPass : kMismatch;
}

int bench(const Options& options) {
  const BoardSpeed speed = bench_board(options.bench);
  options.output.text(to_string(speed));
  options.output.json(to_json(speed));
  return speed.failures == 0 && speed.checks > 0 ? kPass : kMismatch;
}

}  // namespace

void add_board_command(CommandLine& commands) {
  auto options = std::make_shared<Options>();
  auto chosen = std::make_shared<int (*)(const Options&)>(nullptr);
  const Command board =
      commands.add("board", "A board on USB: what is plugged in, what it has, whether and how fast it works",
                   [options, chosen] { return (*chosen)(*options); });
  board.require_subcommand(1);
  const auto add = [&](const char* name, const char* description, int (*run)(const Options&)) {
    const Command command = board.add_subcommand(name, description);
    command.callback([chosen, run] { *chosen = run; });
    options->output.add_option(command);
    return command;
  };
  add("list", "Lists the devices that may be boards", &list);
  add_board_options(add("info", "What a board says of itself", &info));
  const Command test =
      add("selftest", "Runs generated cases of every unit that a board has, and compares with the golden", &selftest);
  test.add_option("--cases", options->selftest.cases, "of a unit without state; a tenth of one with state")
      .capture_default_str();
  test.add_option("--seed", options->selftest.seed, "of the cases").capture_default_str();
  add_board_options(test);
  const Command speed = add("bench", "Measures vectors and bytes a second, and what frames cost", &bench);
  speed.add_option("--unit", options->bench.unit, "whose vectors").capture_default_str().type_name("UNIT");
  speed.add_option("--cases", options->bench.cases, "of a set").capture_default_str();
  speed.add_option("--repeat", options->bench.repeat, "how often to run the set").capture_default_str();
  add_board_options(speed);
}

}  // namespace cbvh::testbench
