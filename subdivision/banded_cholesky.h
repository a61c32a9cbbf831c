// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace stratareeb {

//! A symmetric positive definite matrix whose numbers lie near the diagonal, and its Cholesky factors, block by block in
//! dense arithmetic (G. H. Golub, C. F. Van Loan, Matrix Computations, 4.3.5). That is far faster than sparse factors where
//! most of the band is filled in, as it is for functions on a grid.
class BandedCholesky {
 public:
    //! All numbers 0.
    //! \param reach how far from the diagonal numbers may lie
    BandedCholesky(std::size_t size, std::size_t reach);

    //! A number on the diagonal or below, column <= row <= column + reach.
    double& at(std::size_t row, std::size_t column) { return band_[column * stride_ + (row - column)]; }

    //! In place of the matrix.
    //! \return false if the matrix is not positive definite: then there are none
    [[nodiscard]] bool factorize();

    //! \pre factorized
    void solve_in_place(std::span<double> right_side) const;

 private:
    std::size_t width_of(std::size_t first) const;  // of the block that begins there
    std::size_t below(std::size_t end) const;       // rows below a block that it has to do with

    std::size_t size_, reach_, stride_;
    std::vector<double> band_;  // column by column, with zeros below the band so that blocks are full
};

}  // namespace stratareeb
