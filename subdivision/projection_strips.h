// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "subdivision/smooth_brep.h"

namespace stratareeb {

//! Cut faces into strips where CAD programs would take long to open them: for each edge that is more than a millimetre from a
//! face, OpenCASCADE looks for its place in the face anew, and lays a grid over all the face's spans for it
//! (XSAlgo_AlgoContainer::CheckPCurve, Extrema_GenExtPS::BuildGrid of version 7.6). Faces with many such edges over many spans are halved.
//! \param close how far an edge may be from a face, in the model's unit of length
//! \return whether any was halved
bool cut_for_projection(SmoothBrep& brep, double close);

}  // namespace stratareeb
