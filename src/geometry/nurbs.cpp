// SPDX-License-Identifier: Apache-2.0
#include "geometry/nurbs.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <utility>

namespace hexweave {

namespace {

/// A control point times its weight, and the weight.
struct Homogeneous {
    Vec3 point;
    double weight = 0;
};

Homogeneous operator*(double f, const Homogeneous& a) {
    return {f * a.point, f * a.weight};
}

Homogeneous& operator+=(Homogeneous& a, const Homogeneous& b) {
    a.point += b.point;
    a.weight += b.weight;
    return a;
}

std::vector<Homogeneous> homogeneous(const std::vector<Vec3>& control,
                                     const std::vector<double>& weights) {
    std::vector<Homogeneous> points;
    points.reserve(control.size());
    for (std::size_t n = 0; n < control.size(); ++n) {
        const double weight = weights.empty() ? 1 : weights[n];
        points.push_back({weight * control[n], weight});
    }
    return points;
}

Vec3 position_of(const Homogeneous& value) {
    return value.point / value.weight;
}

/// The derivative of the quotient.
Vec3 derivative_of(const Homogeneous& value, const Homogeneous& derivative) {
    return (derivative.point - derivative.weight * position_of(value)) / value.weight;
}

/// The basis functions that do not vanish at a parameter, or their derivatives: those of the
/// control points first, ..., first + degree.
struct Basis {
    std::size_t first = 0;
    std::array<double, greatest_nurbs_degree + 1> values{};
};

/// A degree and its knots.
class Knots {
public:
    Knots(int degree, std::vector<double> knots)
        : degree_(static_cast<std::size_t>(degree)), knots_(std::move(knots)) {}

    std::size_t degree() const { return degree_; }
    double begin() const { return knots_[degree_]; }
    double end() const { return knots_[knots_.size() - 1 - degree_]; }

    /// The inner knots, each once.
    std::vector<double> breaks() const {
        std::vector<double> inner;
        std::copy_if(knots_.begin(), knots_.end(), std::back_inserter(inner),
                     [&](double t) { return t > begin() && t < end(); });
        inner.erase(std::unique(inner.begin(), inner.end()), inner.end());
        return inner;
    }

    Basis values(double t) const {
        const std::size_t span = span_of(t);
        Basis basis{span - degree_, {}};
        raise(t, span, degree_, basis.values);
        return basis;
    }

    /// By the basis functions of one degree less.
    Basis derivatives(double t) const {
        const std::size_t span = span_of(t);
        Basis basis{span - degree_, {}};
        std::array<double, greatest_nurbs_degree + 1> lower{};
        raise(t, span, degree_ - 1, lower);
        for (std::size_t r = 0; r < degree_; ++r) {
            const std::size_t k = span - degree_ + 1 + r;
            const double slope =
                static_cast<double>(degree_) * lower[r] / (knots_[k + degree_] - knots_[k]);
            basis.values[r] -= slope;
            basis.values[r + 1] += slope;
        }
        return basis;
    }

private:
    /// The interval between different knots that holds t: the last of them at the end.
    std::size_t span_of(double t) const {
        const auto first = knots_.begin() + static_cast<std::ptrdiff_t>(degree_) + 1;
        const auto last = knots_.end() - 1 - static_cast<std::ptrdiff_t>(degree_);
        const auto above =
            t < *last ? std::upper_bound(first, last, t) : std::lower_bound(first, last, *last);
        return static_cast<std::size_t>(above - knots_.begin()) - 1;
    }

    /// The basis functions of a degree that do not vanish in the interval behind knot `span`.
    void raise(double t, std::size_t span, std::size_t degree,
               std::array<double, greatest_nurbs_degree + 1>& values) const {
        values[0] = 1;
        for (std::size_t p = 1; p <= degree; ++p) {
            double carried = 0;
            for (std::size_t r = 0; r < p; ++r) {
                const double high = knots_[span + 1 + r];
                const double low = knots_[span + 1 + r - p];
                // A quotient, for it is exactly 0 or 1 at the ends.
                const double share = (t - low) / (high - low);
                const double whole = values[r];
                values[r] = carried + (1 - share) * whole;
                carried = share * whole;
            }
            values[p] = carried;
        }
    }

    std::size_t degree_;
    std::vector<double> knots_;
};

struct CurveData {
    Knots knots;
    std::vector<Homogeneous> control;

    Homogeneous sum(const Basis& basis) const {
        Homogeneous total;
        for (std::size_t r = 0; r <= knots.degree(); ++r) {
            total += basis.values[r] * control[basis.first + r];
        }
        return total;
    }
};

struct SurfaceData {
    Knots u;
    Knots v;
    std::size_t count_u;
    std::vector<Homogeneous> control;

    Homogeneous sum(const Basis& along_u, const Basis& along_v) const {
        Homogeneous total;
        for (std::size_t b = 0; b <= v.degree(); ++b) {
            const std::size_t row = along_u.first + (along_v.first + b) * count_u;
            Homogeneous part;
            for (std::size_t a = 0; a <= u.degree(); ++a) {
                part += along_u.values[a] * control[row + a];
            }
            total += along_v.values[b] * part;
        }
        return total;
    }
};

/// In as few digits as tell it apart.
std::string number(double value) {
    std::array<char, 32> text{};
    char* const end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

std::string weights_fault(const std::vector<double>& weights, std::size_t points) {
    if (weights.empty()) return {};
    if (weights.size() != points) {
        return "there are " + std::to_string(weights.size()) + " weights for " +
               std::to_string(points) + " control points";
    }
    for (const double weight : weights) {
        if (!(weight > 0 && std::isfinite(weight))) {
            return "a weight must be positive, not " + number(weight);
        }
    }
    return {};
}

std::string degree_fault(int degree) {
    if (degree >= 1 && degree <= greatest_nurbs_degree) return {};
    return "a degree must be between 1 and " + std::to_string(greatest_nurbs_degree) + ", not " +
           std::to_string(degree);
}

std::string points_fault(const std::vector<Vec3>& points) {
    return std::all_of(points.begin(), points.end(), is_finite) ? ""
                                                                : "a control point is infinite";
}

/// The first of some faults.
std::string first_of(std::initializer_list<std::string> faults) {
    for (const std::string& fault : faults) {
        if (!fault.empty()) return fault;
    }
    return {};
}

std::string count_fault(int count, int degree, const std::string& where) {
    if (count > degree) return {};
    return "degree " + std::to_string(degree) + " needs at least " + std::to_string(degree + 1) +
           " control points" + where + ", not " + std::to_string(count);
}

}  // namespace

std::string knots_fault(const std::vector<double>& knots, int degree, int count) {
    const auto p = static_cast<std::size_t>(degree);
    const std::size_t wanted = static_cast<std::size_t>(count) + p + 1;
    if (knots.size() != wanted) {
        return "degree " + std::to_string(degree) + " and " + std::to_string(count) +
               " control points need " + std::to_string(wanted) + " knots, not " +
               std::to_string(knots.size());
    }
    if (!std::all_of(knots.begin(), knots.end(), [](double t) { return std::isfinite(t); })) {
        return "a knot is infinite";
    }
    const auto descent = std::is_sorted_until(knots.begin(), knots.end());
    if (descent != knots.end()) {
        return "the knots must ascend, not go from " + number(*(descent - 1)) + " to " +
               number(*descent);
    }
    const double begin = knots[p];
    const double end = knots[wanted - 1 - p];
    if (!(begin < end)) return "the knots span no range";
    for (auto at = knots.begin(); at != knots.end();) {
        const auto behind = std::upper_bound(at, knots.end(), *at);
        const auto times = static_cast<std::size_t>(behind - at);
        const std::size_t most = *at > begin && *at < end ? p : p + 1;
        if (times > most) {
            return "the knot " + number(*at) + " stands " + std::to_string(times) +
                   " times, which tears a degree of " + std::to_string(degree);
        }
        at = behind;
    }
    return {};
}

std::string fault_of(const NurbsNet& net) {
    std::string degrees = first_of({degree_fault(net.degree_u), degree_fault(net.degree_v)});
    if (!degrees.empty()) return degrees;
    std::string counts = first_of({count_fault(net.count_u, net.degree_u, " along u"),
                                   count_fault(net.count_v, net.degree_v, " along v")});
    if (!counts.empty()) return counts;
    const std::string u = knots_fault(net.knots_u, net.degree_u, net.count_u);
    if (!u.empty()) return "along u: " + u;
    const std::string v = knots_fault(net.knots_v, net.degree_v, net.count_v);
    if (!v.empty()) return "along v: " + v;
    const auto points =
        static_cast<std::size_t>(net.count_u) * static_cast<std::size_t>(net.count_v);
    if (net.control.size() != points) {
        return "there are " + std::to_string(net.control.size()) + " control points, not " +
               std::to_string(net.count_u) + " times " + std::to_string(net.count_v);
    }
    return first_of({points_fault(net.control), weights_fault(net.weights, points)});
}

std::string fault_of(const NurbsPolygon& polygon) {
    std::string degree = degree_fault(polygon.degree);
    if (!degree.empty()) return degree;
    const int count = static_cast<int>(polygon.control.size());
    return first_of(
        {count_fault(count, polygon.degree, ""),
         count > polygon.degree ? knots_fault(polygon.knots, polygon.degree, count) : "",
         points_fault(polygon.control), weights_fault(polygon.weights, polygon.control.size())});
}

Surface nurbs_surface(NurbsNet net) {
    const auto data = std::make_shared<const SurfaceData>(SurfaceData{
        Knots(net.degree_u, std::move(net.knots_u)), Knots(net.degree_v, std::move(net.knots_v)),
        static_cast<std::size_t>(net.count_u), homogeneous(net.control, net.weights)});
    Surface surface;
    surface.position = [data](double u, double v) {
        return position_of(data->sum(data->u.values(u), data->v.values(v)));
    };
    surface.derivative_u = [data](double u, double v) {
        const Basis across = data->v.values(v);
        return derivative_of(data->sum(data->u.values(u), across),
                             data->sum(data->u.derivatives(u), across));
    };
    surface.derivative_v = [data](double u, double v) {
        const Basis across = data->u.values(u);
        return derivative_of(data->sum(across, data->v.values(v)),
                             data->sum(across, data->v.derivatives(v)));
    };
    surface.range_u = {data->u.begin(), data->u.end()};
    surface.range_v = {data->v.begin(), data->v.end()};
    surface.breaks_u = data->u.breaks();
    surface.breaks_v = data->v.breaks();
    find_closed(surface);
    return surface;
}

Curve nurbs_curve(NurbsPolygon polygon) {
    const auto data =
        std::make_shared<const CurveData>(CurveData{Knots(polygon.degree, std::move(polygon.knots)),
                                                    homogeneous(polygon.control, polygon.weights)});
    Curve curve;
    curve.position = [data](double t) { return position_of(data->sum(data->knots.values(t))); };
    curve.derivative = [data](double t) {
        return derivative_of(data->sum(data->knots.values(t)),
                             data->sum(data->knots.derivatives(t)));
    };
    curve.begin = data->knots.begin();
    curve.end = data->knots.end();
    curve.breaks = data->knots.breaks();
    const Vec3 start = curve.position(curve.begin);
    double reach = 0;
    for (const Vec3& p : polygon.control) reach = std::max(reach, distance(start, p));
    curve.closed = distance(start, curve.position(curve.end)) <= 1e-12 * reach;
    return curve;
}

}  // namespace hexweave
