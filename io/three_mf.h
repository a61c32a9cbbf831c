// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace stratareeb {

//! Owner of one lib3mf object: lib3mf hands out pointers, as it types them void**, that must be released.
class ThreeMfObject {
 public:
    ThreeMfObject() = default;
    ThreeMfObject(const ThreeMfObject&) = delete;
    ThreeMfObject& operator=(const ThreeMfObject&) = delete;
    ~ThreeMfObject();

    void** get() const { return object_; }
    void*** out() { return &object_; }

    //! What lib3mf says about its last failure with this object.
    std::string error() const;

 private:
    void** object_ = nullptr;
};

}  // namespace stratareeb
