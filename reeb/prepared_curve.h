// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reeb/curve.h"

namespace stratareeb {

//! A curve checked and with everything that its parameters leave out: a closed curve's repeated first point dropped (a
//! Bezier curve's added instead), a NURBS curve's knots set, the control points of a periodic one repeated.
//! \throw InvalidInput as ParametricCurve says.
Curve prepared_curve(Curve curve);

}  // namespace stratareeb
