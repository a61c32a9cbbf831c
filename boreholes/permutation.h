// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace stratareeb {

//! 0 … count - 1 in random order, the same with every compiler and the same as Python's
//! `numpy.random.default_rng(seed).permutation(count)` (PCG XSL RR 128/64 by M. O'Neill, 2014, seeded by NumPy's
//! SeedSequence; Fisher-Yates from the end), so that anyone can check a hold-out elsewhere.
//! \pre count <= 2^32
std::vector<std::size_t> random_permutation(std::size_t count, std::uint64_t seed);

}  // namespace stratareeb
