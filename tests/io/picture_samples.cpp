// SPDX-License-Identifier: Apache-2.0
#include "picture_samples.h"

#include <cairo.h>
#include <fmt/format.h>

#include <cstddef>
#include <cstring>

namespace hexweave::samples {

Zone mapped_zone(const std::string& name, const Extent& extent,
                 const std::function<Vec3(double, double, double)>& map) {
    const auto fraction = [](int index, int nodes) {
        return nodes > 1 ? static_cast<double>(index) / (nodes - 1) : 0.0;
    };
    Zone zone{name, PointField(extent)};
    for (int k = 0; k < extent.nk; ++k) {
        for (int j = 0; j < extent.nj; ++j) {
            for (int i = 0; i < extent.ni; ++i) {
                zone.points.set(
                    i, j, k,
                    map(fraction(i, extent.ni), fraction(j, extent.nj), fraction(k, extent.nk)));
            }
        }
    }
    return zone;
}

Zone square_zone(const std::string& name, double x, int nodes) {
    return mapped_zone(name, {nodes, nodes, 1}, [x](double s, double t, double) {
        return Vec3{x + s, t, 0};
    });
}

MultiblockGrid squares(int zones, int nodes) {
    MultiblockGrid grid;
    grid.cell_dimension = 2;
    grid.physical_dimension = 2;
    grid.units = std::string("m");
    grid.families = {{"left", "BCInflow"}, {"right", "BCOutflow"}};
    for (int zone = 0; zone < zones; ++zone) {
        grid.zones.push_back(square_zone(fmt::format("square{}", zone), zone, nodes));
    }
    const Extent extent{nodes, nodes, 1};
    grid.patches.push_back({"start", 0, side_box(Side::imin, extent), 0});
    grid.patches.push_back({"end", zones - 1, side_box(Side::imax, extent), 1});
    return grid;
}

MultiblockGrid cube(int nodes) {
    MultiblockGrid grid;
    grid.families = {{"floor", "BCWall"}, {"roof", "BCFarfield"}};
    grid.zones.push_back(
        mapped_zone("cube", {nodes, nodes, nodes}, [](double s, double t, double u) {
            return Vec3{s, t, u};
        }));
    const Extent extent{nodes, nodes, nodes};
    grid.patches.push_back({"bottom", 0, side_box(Side::kmin, extent), 0});
    grid.patches.push_back({"top", 0, side_box(Side::kmax, extent), 1});
    return grid;
}

Image read_png(const std::filesystem::path& path) {
    cairo_surface_t* const surface = cairo_image_surface_create_from_png(path.c_str());
    Image image;
    image.width = cairo_image_surface_get_width(surface);
    image.height = cairo_image_surface_get_height(surface);
    const unsigned char* const data = cairo_image_surface_get_data(surface);
    const auto stride = static_cast<std::ptrdiff_t>(cairo_image_surface_get_stride(surface));
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            std::uint32_t rgb = 0;
            std::memcpy(&rgb, data + y * stride + std::ptrdiff_t{4} * x, sizeof rgb);
            image.pixels.push_back({static_cast<int>(rgb >> 16U & 255U),
                                    static_cast<int>(rgb >> 8U & 255U),
                                    static_cast<int>(rgb & 255U)});
        }
    }
    cairo_surface_destroy(surface);
    return image;
}

}  // namespace hexweave::samples
