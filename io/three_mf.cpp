// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf.h"

#include <Model/COM/NMR_DLLInterfaces.h>

namespace stratareeb {

ThreeMfObject::~ThreeMfObject() {
    if (object_ != nullptr) NMR::lib3mf_release(object_);
}

std::string ThreeMfObject::error() const {
    DWORD code = 0;
    LPCSTR message = nullptr;
    if (object_ == nullptr || NMR::lib3mf_getlasterror(object_, &code, &message) != 0 || message == nullptr)
        return "unknown error";
    return message;
}

}  // namespace stratareeb
