// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "boreholes/audit.h"
#include "boreholes/borehole.h"

namespace stratareeb {

//! A folder of this test's own that goes with it.
class TempFolder {
 public:
    TempFolder()
        : path_(std::filesystem::temp_directory_path() / ("stratareeb_" + std::to_string(getpid()))) {
        std::filesystem::create_directories(path_);
    }
    ~TempFolder() {
        std::error_code none;
        std::filesystem::remove_all(path_, none);
    }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    std::string path(const std::string& name) const { return (path_ / name).string(); }

    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path(name), std::ios::binary) << text;
        return path(name);
    }

 private:
    std::filesystem::path path_;
};

//! Warnings that contain a text.
inline std::size_t count_warnings(const Audit& audit, const std::string& text) {
    std::size_t count = 0;
    for (const Finding& finding : audit.findings())
        count += finding_line(finding).find(text) != std::string::npos;
    return count;
}

//! A layer as one word: "?" unknown, ">2" at least, "2" measured.
inline std::string told(const LayerFact& fact) {
    if (fact.knowledge == Knowledge::Unknown) return "?";
    std::string number = std::to_string(fact.thickness);
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.') number.pop_back();
    if (fact.knowledge == Knowledge::AtLeast) number.insert(number.begin(), '>');
    return number;
}

//! A hole's layers as words.
inline std::string told(const Borehole& hole) {
    std::string text;
    for (const LayerFact& fact : hole.layers) text.append(text.empty() ? "" : " ").append(told(fact));
    return text;
}

//! A hole's known elevations, "_" where unknown.
inline std::string elevations(const Borehole& hole) {
    std::string text;
    for (const auto& z : hole.horizons)
        text.append(text.empty() ? "" : " ").append(z ? told(LayerFact{Knowledge::Measured, *z}) : "_");
    return text;
}

//! Unit codes from top to bottom.
inline std::string codes(const Survey& survey) {
    std::string text;
    for (const Unit& unit : survey.units) text.append(text.empty() ? "" : " ").append(unit.code);
    return text;
}

}  // namespace stratareeb
