#include "bullet/ground/standing_base.h"

#include <algorithm>

namespace sherd {

namespace {

constexpr btScalar rounding = btScalar(1e-6);  // m

/// A line along the ground.
class Line {
  public:
    Line(const Foot& from, const Foot& to) : from_x_(from.x), from_y_(from.y) {
        const btScalar x = to.x - from.x, y = to.y - from.y, length = btSqrt(x * x + y * y);
        x_ = y / length;
        y_ = -x / length;
    }
    /// How far a point is to the right of it, m.
    btScalar beyond(btScalar x, btScalar y) const { return x_ * (x - from_x_) + y_ * (y - from_y_); }
    btScalar beyond(const Foot& foot) const { return beyond(foot.x, foot.y); }

  private:
    btScalar from_x_, from_y_;
    btScalar x_, y_;  // to the right
};

/// The foot of the largest value; nullptr if none is above that of rounding.
template <class Value>
const Foot* furthest(const std::vector<Foot>& feet, const Value& value) {
    const Foot* best = nullptr;
    btScalar largest = rounding;
    for (const Foot& foot : feet) {
        const btScalar here = value(foot);
        if (!(here > largest)) continue;
        largest = here;
        best = &foot;
    }
    return best;
}

const Foot* furthestBeyond(const std::vector<Foot>& feet, const Line& line, btScalar side) {
    return furthest(feet, [&](const Foot& foot) { return side * line.beyond(foot); });
}

/// Beyond the side of a triangle that the centre is furthest beyond; else what is furthest from all of it.
const Foot* fourth(const std::vector<Foot>& feet, const std::vector<Foot>& triangle) {
    const Line sides[] = {{triangle[0], triangle[1]}, {triangle[1], triangle[2]}, {triangle[2], triangle[0]}};
    const auto centre = [](const Line& side) { return side.beyond(0, 0); };
    const Line& worst =
        *std::max_element(std::begin(sides), std::end(sides),
                          [&](const Line& a, const Line& b) { return centre(a) < centre(b); });
    if (centre(worst) > 0)
        if (const Foot* foot = furthestBeyond(feet, worst, 1)) return foot;
    return furthest(feet, [&](const Foot& foot) {
        return std::max({sides[0].beyond(foot), sides[1].beyond(foot), sides[2].beyond(foot)});
    });
}

bool isUnderCentre(const Foot& a, const Foot& b, const Foot& c) {
    const auto turn = [](const Foot& from, const Foot& to) { return from.x * to.y - from.y * to.x; };
    const btScalar ab = turn(a, b), bc = turn(b, c), ca = turn(c, a);
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

bool isUnderCentre(const std::vector<Foot>& base) {
    const std::size_t count = base.size();
    for (std::size_t i = 0; count > 2 && i < count; ++i)
        if (isUnderCentre(base[i], base[(i + 1) % count], base[(i + 2) % count])) return true;
    return false;
}

/// The lowest foot, one as far from it as can be, and one far to the side of the two where the centre is.
std::vector<Foot> wideTriangle(const std::vector<Foot>& feet, const Foot& lowest) {
    std::vector<Foot> base;
    base.reserve(4);
    base.push_back(lowest);
    const Foot* second = furthest(feet, [&](const Foot& foot) {
        return btSqrt((foot.x - lowest.x) * (foot.x - lowest.x) + (foot.y - lowest.y) * (foot.y - lowest.y));
    });
    if (!second) return base;
    base.push_back(*second);
    const Line line(lowest, *second);
    const btScalar side = line.beyond(0, 0) < 0 ? btScalar(-1) : btScalar(1);
    const Foot* third = furthestBeyond(feet, line, side);
    if (!third) third = furthestBeyond(feet, line, -side);
    if (third) base.push_back(*third);
    return base;
}

/// Those on the corners of the hull of all, in turn (Andrew's monotone chain).
std::vector<const Foot*> cornersOf(const std::vector<Foot>& all) {
    std::vector<const Foot*> feet;
    feet.reserve(all.size());
    for (const Foot& foot : all) feet.push_back(&foot);
    std::sort(feet.begin(), feet.end(),
              [](const Foot* a, const Foot* b) { return a->x < b->x || (a->x == b->x && a->y < b->y); });
    std::vector<const Foot*> corners;
    corners.reserve(2 * feet.size());
    const auto addSide = [&](auto first, auto last) {
        const std::size_t start = corners.size();
        const auto is_reflex = [&](const Foot& next) {
            const Foot &from = *corners[corners.size() - 2], &over = *corners.back();
            return (over.x - from.x) * (next.y - from.y) <= (over.y - from.y) * (next.x - from.x);
        };
        for (; first != last; ++first) {
            while (corners.size() > start + 1 && is_reflex(**first)) corners.pop_back();
            corners.push_back(*first);
        }
        corners.pop_back();  // the first of the other side
    };
    addSide(feet.begin(), feet.end());
    addSide(feet.rbegin(), feet.rend());
    return corners;
}

/// The lowest foot and two more between which the way from it over the centre leaves the hull of all; nothing
/// if the centre is over no triangle.
std::vector<Foot> triangleUnderCentre(const std::vector<Foot>& feet, const Foot& lowest) {
    const std::vector<const Foot*> corners = cornersOf(feet);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Foot &second = *corners[i], &third = *corners[(i + 1) % corners.size()];
        const auto is_lowest = [&](const Foot& foot) { return foot.x == lowest.x && foot.y == lowest.y; };
        if (is_lowest(second) || is_lowest(third)) continue;
        const btScalar across = (third.x - second.x) * lowest.y - (third.y - second.y) * lowest.x;
        if (across != 0 && isUnderCentre(lowest, second, third)) return {lowest, second, third};
    }
    return {};
}

/// Counter-clockwise.
void order(std::vector<Foot>& triangle) {
    if (Line(triangle[0], triangle[1]).beyond(triangle[2]) > 0) std::swap(triangle[1], triangle[2]);
}

std::vector<Foot> withFourth(const std::vector<Foot>& feet, std::vector<Foot> triangle) {
    if (triangle.size() < 3) return triangle;
    order(triangle);
    if (const Foot* last = fourth(feet, triangle)) triangle.push_back(*last);
    return triangle;
}

}  // namespace

std::vector<Foot> standingBase(const std::vector<Foot>& feet) {
    const Foot& lowest = *std::min_element(feet.begin(), feet.end(),
                                           [](const Foot& a, const Foot& b) { return a.above < b.above; });
    std::vector<Foot> wide = withFourth(feet, wideTriangle(feet, lowest));
    if (wide.size() < 4 || isUnderCentre(wide)) return wide;
    const std::vector<Foot> triangle = triangleUnderCentre(feet, lowest);
    return triangle.empty() ? wide : withFourth(feet, triangle);
}

}  // namespace sherd
