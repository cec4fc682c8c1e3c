// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "vectors/vector_set.h"

/// The units, and how a set of cases of any of them comes to be.
namespace cbvh::vectors {

/// All units, in the order of their place in the hardware.
std::span<const UnitDescription> units();

/// Throws InputError("unit", ...) naming the units when there is none of this name.
const UnitDescription& find_unit(std::string_view name);

/// A set without cases. Throws InputError when the unit cannot have these parameters.
std::unique_ptr<VectorSet> make_set(const UnitDescription& unit, const Parameters& parameters, std::uint64_t seed);

/// The cases of ids 0 .. cases - 1 that belong to the shard, with the golden's responses. Case `id` has class id modulo
/// the number of generated classes, and is the same whatever `cases` and the shard. Throws InputError for an unknown
/// unit, bad parameters, or a shard that is not below its count.
std::unique_ptr<VectorSet> generate_set(std::string_view unit, const Parameters& parameters, std::uint64_t cases,
                                        std::uint64_t seed, Shard shard = {});

}  // namespace cbvh::vectors
