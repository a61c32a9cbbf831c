// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_picture.h"

#include <cairo.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "boreholes/errors.h"
#include "tests/planar_shapes.h"

namespace stratareeb {
namespace {

using test::level;
using test::slab;

struct Image {
    int width = 0, height = 0;
    std::vector<std::uint32_t> pixels;
};

Image read(const std::filesystem::path& png) {
    cairo_surface_t* surface = cairo_image_surface_create_from_png(png.c_str());
    EXPECT_EQ(cairo_surface_status(surface), CAIRO_STATUS_SUCCESS);
    Image image{cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
    const unsigned char* data = cairo_image_surface_get_data(surface);
    for (int y = 0; y < image.height; ++y) {
        const auto* row =
            reinterpret_cast<const std::uint32_t*>(data + y * cairo_image_surface_get_stride(surface));
        image.pixels.insert(image.pixels.end(), row, row + image.width);
    }
    cairo_surface_destroy(surface);
    return image;
}

struct Extent {
    int pixels = 0, x_low = 1 << 30, x_high = -1, y_low = 1 << 30, y_high = -1;
    int height() const { return y_high - y_low + 1; }
    int width() const { return x_high - x_low + 1; }
};

enum class Hue { Red, Green, Blue };

// Where one channel rules: light and outlines change the brightness, not the hue. The legend is left out.
Extent extent(const Image& image, Hue hue, double share_of_width = 0.925) {
    Extent found;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width * share_of_width; ++x) {
            const auto pixel = image.pixels[static_cast<std::size_t>(y) * image.width + x];
            const int rgb[] = {static_cast<int>(pixel >> 16 & 255), static_cast<int>(pixel >> 8 & 255),
                               static_cast<int>(pixel & 255)};
            const int own = rgb[static_cast<int>(hue)];
            const int others = rgb[0] + rgb[1] + rgb[2] - own;
            if (own < 40 || own < 1.5 * others) continue;
            ++found.pixels;
            found.x_low = std::min(found.x_low, x);
            found.x_high = std::max(found.x_high, x);
            found.y_low = std::min(found.y_low, y);
            found.y_high = std::max(found.y_high, y);
        }
    }
    return found;
}

class WritePicture : public testing::Test {
 protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() / (std::string("write_picture_") + info->name());
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    Image draw(const std::vector<LayerSolid>& layers, const PictureOptions& options) {
        write_picture(folder_ / "picture.png", layers, options);
        return read(folder_ / "picture.png");
    }

    std::filesystem::path folder_;
};

LayerSolid layer(const std::string& color, double top, double base, double size = 100) {
    return {1, 0, {"u", "unit", color}, slab({.n = 4, .size = size, .top = level(top), .base = level(base)})};
}

const PictureOptions kSmall{.width = 480, .height = 300};

PictureOptions from_the_side() {
    auto options = kSmall;
    options.azimuth_deg = 0;
    options.elevation_deg = 0;
    options.explode = 0;
    return options;
}

TEST_F(WritePicture, has_the_size_asked_for_on_white) {
    const auto image = draw({layer("#ff0000", 0, -20)}, kSmall);
    EXPECT_EQ(image.width, 480);
    EXPECT_EQ(image.height, 300);
    EXPECT_EQ(image.pixels[0] & 0xffffff, 0xffffffu);
}

TEST_F(WritePicture, every_layer_shows_in_its_colour_and_an_absent_one_does_not) {
    const LayerSolid absent{2, 0, {"b", "absent", "#0000ff"}, {}};
    const auto image = draw({layer("#ff0000", 0, -20), absent, layer("#00ff00", -20, -50)}, kSmall);
    EXPECT_GT(extent(image, Hue::Red).pixels, 5000);
    EXPECT_GT(extent(image, Hue::Green).pixels, 1000);
    EXPECT_EQ(extent(image, Hue::Blue, 1.0).pixels, 0);  // not in the legend either
}

TEST_F(WritePicture, what_is_behind_is_hidden) {
    auto hidden = layer("#0000ff", -5, -15, 20);
    for (const auto v : hidden.surface.vertices())
        hidden.surface.set_point(v, hidden.surface.point(v) + OpenMesh::Vec3d(40, 40, 0));
    auto options = kSmall;
    options.explode = 0;
    const auto image = draw({layer("#ff0000", 0, -20), hidden}, options);
    EXPECT_EQ(extent(image, Hue::Blue).pixels, 0);
}

TEST_F(WritePicture, from_the_side_a_box_has_its_proportions) {
    auto options = from_the_side();
    for (const double exaggeration : {1.0, 3.0}) {
        options.vertical_exaggeration = exaggeration;
        const auto found = extent(draw({layer("#ff0000", 0, -10)}, options), Hue::Red);
        const double ratio = static_cast<double>(found.height()) / found.width();
        EXPECT_NEAR(ratio, 0.1 * exaggeration, 0.015) << exaggeration;
    }
}

TEST_F(WritePicture, exploded_layers_stand_apart_by_the_fraction_asked_for) {
    auto options = from_the_side();
    options.vertical_exaggeration = 1;
    options.explode = 0.5;
    const auto image = draw({layer("#ff0000", 0, -20), layer("#00ff00", -20, -40)}, options);
    const auto red = extent(image, Hue::Red), green = extent(image, Hue::Green);
    EXPECT_NEAR(green.y_low - red.y_high - 1, red.height(),
                3);  // half of the model's 40 is 20, a layer's thickness
}

TEST_F(WritePicture, the_eye_stands_where_azimuth_says) {
    // The western half red, the eastern half green; from the north, east is on the left.
    auto east = layer("#00ff00", 0, -10, 50), west = layer("#ff0000", 0, -10, 50);
    for (const auto v : east.surface.vertices())
        east.surface.set_point(v, east.surface.point(v) + OpenMesh::Vec3d(50, 0, 0));
    auto options = from_the_side();
    auto image = draw({west, east}, options);
    EXPECT_LT(extent(image, Hue::Red).x_high, extent(image, Hue::Green).x_low + 3);
    options.azimuth_deg = 180;
    image = draw({west, east}, options);
    EXPECT_GT(extent(image, Hue::Red).x_low, extent(image, Hue::Green).x_high - 3);
}

TEST_F(WritePicture, holes_stick_out_of_the_ground) {
    auto options = from_the_side();
    const auto ink_above_ground = [](const Image& image) {
        const int ground = extent(image, Hue::Red).y_low - 2, legend = static_cast<int>(0.92 * image.width);
        int ink = 0;
        for (int y = 0; y < ground; ++y)
            for (int x = 0; x < legend; ++x)
                ink += (image.pixels[static_cast<std::size_t>(y) * image.width + x] & 0xff) < 128;
        return ink;
    };
    EXPECT_EQ(ink_above_ground(draw({layer("#ff0000", 0, -20)}, options)), 0);
    options.holes = {{{50, 50, 0}, -20}};
    EXPECT_GT(ink_above_ground(draw({layer("#ff0000", 0, -20)}, options)), 2);
}

TEST_F(WritePicture, the_same_input_gives_the_same_bytes) {
    const auto bytes = [&](const char* name) {
        const std::vector<LayerSolid> layers{layer("#ff0000", 0, -20), layer("#00ff00", -20, -50)};
        write_picture(folder_ / name, layers, {.width = 300, .height = 200, .title = "Schichten"});
        std::ostringstream text;
        text << std::ifstream(folder_ / name, std::ios::binary).rdbuf();
        return text.str();
    };
    EXPECT_EQ(bytes("a.png"), bytes("b.png"));
}

TEST_F(WritePicture, odd_models_are_drawn) {
    const LayerSolid lens{1, 0, {"l", std::string(300, 'x'), ""}, test::cone_lens(24, 4, 1e6, 1e-3, 1e-3)};
    EXPECT_GT(draw({lens}, kSmall).width, 0);
    auto straight_down = kSmall;
    straight_down.elevation_deg = 90;
    EXPECT_GT(extent(draw({layer("#ff0000", 0, -1)}, straight_down), Hue::Red).pixels, 10000);
    auto far = layer("#ff0000", 5e6 + 1, 5e6);
    EXPECT_GT(extent(draw({far}, kSmall), Hue::Red).pixels, 5000);
}

TEST_F(WritePicture, bad_input_is_refused) {
    EXPECT_THROW(draw({}, kSmall), InvalidInput);
    EXPECT_THROW(draw({layer("#ff0000", 0, -1)}, {.width = 0}), InvalidInput);
    EXPECT_THROW(draw({layer("#ff0000", 0, -1)}, {.elevation_deg = 91}), InvalidInput);
    EXPECT_THROW(draw({layer("#ff0000", 0, -1)}, {.explode = std::nan("")}), InvalidInput);
    EXPECT_THROW(draw({layer("scarlet", 0, -1)}, kSmall), InvalidInput);
    const std::vector<LayerSolid> layers{layer("#ff0000", 0, -1)};
    EXPECT_THROW(write_picture(folder_ / "nowhere" / "a.png", layers, kSmall), IoError);
}

}  // namespace
}  // namespace stratareeb
