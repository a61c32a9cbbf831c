// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/step_sharing.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <map>
#include <random>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "boreholes/errors.h"

namespace stratareeb {
namespace {

const std::string kHead = "ISO-10303-21;\nHEADER;\nFILE_NAME('a #1; b');\nENDSEC;\nDATA;\n";
const std::string kTail = "ENDSEC;\nEND-ISO-10303-21;\n";

std::string share(const std::string& text) {
    std::ostringstream stream;
    share_step_geometry(text, stream);
    return stream.str();
}

std::string shared(const std::string& data) {
    const std::string whole = share(kHead + data + kTail);
    EXPECT_EQ(whole.substr(0, kHead.size()), kHead);
    EXPECT_EQ(whole.substr(whole.size() - kTail.size()), kTail);
    return whole.substr(kHead.size(), whole.size() - kHead.size() - kTail.size());
}

TEST(StepSharing, what_says_the_same_is_there_once) {
    EXPECT_EQ(shared("#1 = LINE('',#2,#3);\n"
                     "#2 = CARTESIAN_POINT('',(1.,2.,3.));\n"
                     "#3 = VECTOR('',#4,1.);\n"
                     "#4 = DIRECTION('',(1.,0.,0.));\n"
                     "#5 = LINE('',#6,#7);\n"
                     "#6 = CARTESIAN_POINT('',(1.,\n    2.,3.));\n"
                     "#7 = VECTOR('',#8,1.);\n"
                     "#8 = DIRECTION('',(1.,0.,0.));\n"
                     "#9 = EDGE_CURVE('',#10,#11,#1,.T.);\n"
                     "#10 = VERTEX_POINT('',#2);\n"
                     "#11 = VERTEX_POINT('',#6);\n"
                     "#12 = EDGE_CURVE('',#11,#10,#5,\n  .T.);\n"),
              "#1 = LINE('',#2,#3);\n"
              "#2 = CARTESIAN_POINT('',(1.,2.,3.));\n"
              "#3 = VECTOR('',#4,1.);\n"
              "#4 = DIRECTION('',(1.,0.,0.));\n"
              "#5 = EDGE_CURVE('',#6,#7,#1,.T.);\n"
              "#6 = VERTEX_POINT('',#2);\n"
              "#7 = VERTEX_POINT('',#2);\n"
              "#8 = EDGE_CURVE('',#7,#6,#1,\n  .T.);\n");
}

TEST(StepSharing, what_differs_stays) {
    const std::string data =
        "#1 = CARTESIAN_POINT('',(1.,2.));\n"
        "#2 = CARTESIAN_POINT('',(1.,2.,0.));\n"
        "#3 = DIRECTION('',(1.,2.,0.));\n"
        "#4 = CARTESIAN_POINT('corner',(1.,2.,0.));\n"
        "#5 = CARTESIAN_POINT('cor ner',(1.,2.,0.));\n"
        "#6 = PRODUCT('it''s #7; and ''#8','',$,(#1));\n"
        "#7 = AXIS2_PLACEMENT_3D('',#2,#3,$);\n"  // programs tell them apart by what they belong to
        "#8 = AXIS2_PLACEMENT_3D('',#2,#3,$);\n"
        "#9 = ( A(2) B('',#1) );\n";
    EXPECT_EQ(shared(data), data);
    EXPECT_EQ(shared(""), "");
}

TEST(StepSharing, what_is_no_step_is_refused) {
    EXPECT_THROW(share(""), InvalidInput);
    EXPECT_THROW(share("solid\n"), InvalidInput);
    EXPECT_THROW(shared("#1 = LINE('',#2,#3);\n"), InvalidInput);
    EXPECT_THROW(shared("#1 = DIRECTION('',(1.,0.,0.));\n#1 = DIRECTION('',(0.,0.,1.));\n"), InvalidInput);
    EXPECT_THROW(shared("#1 = PRODUCT('never ends"), InvalidInput);
    EXPECT_THROW(shared("#1 = LINE('',#,#1);\n"), InvalidInput);
    EXPECT_THROW(shared("# = DIRECTION('',(1.,0.,0.));\n"), InvalidInput);
}

// What an entity says with all that it refers to.
class Expanded {
 public:
    explicit Expanded(const std::string& data) {
        const std::regex line("#(\\d+) = (.*);\n");
        for (std::sregex_iterator it(data.begin(), data.end(), line), end; it != end; ++it) {
            texts_[(*it)[1]] = (*it)[2];
            numbers_.push_back((*it)[1]);
        }
    }

    std::string of(const std::string& number) const {
        std::string text = texts_.at(number), result;
        std::smatch reference;
        while (std::regex_search(text, reference, std::regex("#(\\d+)"))) {
            result += reference.prefix().str() + "{" + of(reference[1]) + "}";
            text = reference.suffix();
        }
        return result + text;
    }

    std::vector<std::string> faces() const {
        std::vector<std::string> result;
        for (const auto& number : numbers_)
            if (texts_.at(number).starts_with("ADVANCED_FACE")) result.push_back(of(number));
        return result;
    }

    std::size_t size() const { return numbers_.size(); }

 private:
    std::map<std::string, std::string> texts_;
    std::vector<std::string> numbers_;
};

TEST(StepSharing, random_faces_keep_their_geometry) {
    for (unsigned seed = 0; seed < 30; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
        std::string data;
        int number = 0;
        for (int face = 0; face < 12; ++face) {
            const int first = number + 1;  // what comes first refers to what follows
            data += fmt::format("#{} = ADVANCED_FACE('',(#{}),#{},.T.);\n", first, first + 1, first + 2);
            data += fmt::format("#{} = LINE('',#{},#{});\n", first + 1, first + 3, first + 4);
            data += fmt::format("#{} = B_SPLINE_SURFACE_WITH_KNOTS('',3,3,((#{},#{})),{}.);\n", first + 2,
                                first + 3, first + 6, pick(2));
            data += fmt::format("#{} = CARTESIAN_POINT('',({}.,0.,0.));\n", first + 3, pick(3));
            data += fmt::format("#{} = VECTOR('',#{},1.);\n", first + 4, first + 5);
            data += fmt::format("#{} = DIRECTION('',({}.,0.,1.));\n", first + 5, pick(2));
            data += fmt::format("#{} = CARTESIAN_POINT('',({}.,0.,0.));\n", first + 6, pick(3));
            number += 7;
        }
        const std::string once = shared(data);
        const Expanded before(data), after(once);
        EXPECT_EQ(after.faces(), before.faces());
        EXPECT_LE(after.size(), 12 + 3 + 2 + 2 + 6 + 3 * 3 * 2U);  // each kind has no more
        EXPECT_EQ(shared(once), once);
    }
}

}  // namespace
}  // namespace stratareeb
