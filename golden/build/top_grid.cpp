// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/top_grid.h"

#include <algorithm>
#include <bit>

#include "golden/build/sah_bins.h"

namespace cbvh::golden {
namespace {

/// A grid of 2^levels cells. A cell's code has a bit for each halving, the first the most significant: cells in order
/// of their codes are in the order of the leaves of the tree that halves the grid.
class CellCodes {
 public:
  CellCodes(const WideBox& centroids, int most_levels) : mapping_(cut(centroids, most_levels)) {}

  int levels() const { return levels_; }
  std::uint32_t code_of(Float4 centroid) const {
    const Int4 cell = mapping_.bin_of(centroid);
    std::uint32_t code = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) code |= codes_[axis][static_cast<std::size_t>(cell[axis])];
    return code;
  }

 private:
  BinMapping cut(const WideBox& centroids, int most_levels) {
    WideBox cell = centroids;  // lower end only matters for the extent
    std::array<int, 3> cells{1, 1, 1};
    codes_ = {{{0}, {0}, {0}}};
    for (; levels_ < most_levels; ++levels_) {
      const auto axis = static_cast<std::size_t>(longest_axis(cell));
      const float middle = cell.lower[axis] * 0.5F + cell.upper[axis] * 0.5F;
      if (!(middle > cell.lower[axis])) break;
      cell.upper[axis] = middle;
      cells[axis] *= 2;
      std::vector<std::uint32_t> twice;
      for (const std::uint32_t code : codes_[axis]) twice.insert(twice.end(), {code, code | 1U << 31 >> levels_});
      codes_[axis] = std::move(twice);
    }
    for (auto& of_axis : codes_) {
      for (std::uint32_t& code : of_axis) code = levels_ == 0 ? 0 : code >> (32 - levels_);
    }
    return {centroids, cells};
  }

  int levels_ = 0;
  std::array<std::vector<std::uint32_t>, 3> codes_;  ///< of each cell along an axis: its bits of the code
  BinMapping mapping_;
};

struct Cell {
  std::uint32_t count = 0;
  WideBox box;
};

class TopGrid {
 public:
  TopGrid(const BuildLimits& limits, int levels, SubtreeArrays& arrays)
      : limits_(limits),
        levels_(std::min(levels, static_cast<int>(std::bit_width(arrays.count() / kTrianglesPerCell)))),
        arrays_(arrays),
        written_(static_cast<std::size_t>(limits.threads)),
        grids_(static_cast<std::size_t>(limits.threads)) {}

  /// What each member does.
  void run(const Mesh& mesh, const TeamMember& member) {
    written_[member.index()] = write_references(mesh, member, arrays_);
    member.wait();
    WideBox centroids;
    for (const auto& boxes : written_) centroids.enclose(boxes[1]);
    const CellCodes codes(centroids, levels_);
    const TeamMember::Share share = member.share(arrays_.count());
    const Reference* const from = arrays_.buffer(false);
    std::vector<Cell>& mine = grids_[member.index()];
    mine.resize(std::size_t{1} << static_cast<unsigned>(codes.levels()));
    for (std::uint32_t i = share.first; i < share.last; ++i) {
      Cell& cell = mine[codes.code_of(from[i].box().centroid())];
      ++cell.count;
      cell.box.enclose(from[i].box());
    }
    member.wait();
    std::vector<std::uint32_t> next(mine.size());  // where my references of each cell go
    std::uint32_t sum = 0;
    for (std::size_t code = 0; code < mine.size(); ++code) {
      for (unsigned other = 0; other < member.size(); ++other) {
        if (other == member.index()) next[code] = sum;
        sum += grids_[other][code].count;
      }
    }
    Reference* const to = arrays_.buffer(true);
    for (std::uint32_t i = share.first; i < share.last; ++i)
      to[next[codes.code_of(from[i].box().centroid())]++] = from[i];
    member.wait();
    if (member.index() == 0) levels_ = codes.levels();
    const TeamMember::Share cells = member.share(static_cast<std::uint32_t>(mine.size()));
    for (std::uint32_t code = cells.first; code < cells.last; ++code) {
      for (unsigned other = 1; other < member.size(); ++other) {
        grids_[0][code].count += grids_[other][code].count;
        grids_[0][code].box.enclose(grids_[other][code].box);
      }
    }
  }

  /// Then, by one of them, the nodes.
  std::vector<Subtree> nodes() {
    Subtree root{.count = arrays_.count(), .levels = limits_.depth, .side = true, .box = {}};
    for (const auto& boxes : written_) root.box.enclose(boxes[0]);
    halve(root, 0, levels_);
    return std::move(subtrees_);
  }

 private:
  Cell sum(std::size_t first, std::size_t count) const {
    Cell all;
    for (std::size_t code = first; code < first + count; ++code) {
      all.count += grids_[0][code].count;
      all.box.enclose(grids_[0][code].box);
    }
    return all;
  }

  /// `node` has the 2^levels cells from `first` on.
  void halve(const Subtree& node, std::size_t first, int levels) {
    if (levels == 0) return subtrees_.push_back(node);
    if (node.count <= limits_.leaf) return leave(node);
    const std::size_t half = std::size_t{1} << static_cast<unsigned>(levels - 1);
    const Cell left = sum(first, half);
    const Cell right = sum(first + half, half);
    if (left.count == 0) return halve(node, first + half, levels - 1);
    if (right.count == 0) return halve(node, first, levels - 1);
    if (!limits_.fit(left.count, right.count, node.levels)) return leave(node);
    std::array<Subtree, 2> halves = arrays_.split(node, left.count, {left.box, right.box});
    for (std::size_t i = 0; i < 2; ++i) {
      halves[i].side = node.side;
      halve(halves[i], first + i * half, levels - 1);
    }
  }

  /// A subtree of several cells, back in input order.
  void leave(const Subtree& node) {
    Reference* const first = arrays_.buffer(node.side) + node.first;
    std::sort(first, first + node.count, [](const Reference& a, const Reference& b) { return a.id() < b.id(); });
    subtrees_.push_back(node);
  }

  const BuildLimits& limits_;
  int levels_;
  SubtreeArrays& arrays_;
  std::vector<std::array<WideBox, 2>> written_;  ///< by thread: of its references and their centroids
  std::vector<std::vector<Cell>> grids_;         ///< by thread; the first one also takes the sum
  std::vector<Subtree> subtrees_;
};

}  // namespace

std::vector<Subtree> split_by_grid(const Mesh& mesh, const BuildLimits& limits, int levels, SubtreeArrays& arrays) {
  TopGrid top(limits, levels, arrays);
  run_team(static_cast<unsigned>(limits.threads), [&](const TeamMember& member) { top.run(mesh, member); });
  return top.nodes();
}

}  // namespace cbvh::golden
