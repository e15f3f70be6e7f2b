#include "bullet/standing_base.h"

#include <algorithm>

namespace sherd {

namespace {

constexpr btScalar rounding = btScalar(1e-6);  // m

/// A line along the ground.
class Line {
  public:
    Line(const Foot& from, const Foot& to) : from_(from) {
        const btScalar x = to.x - from.x, y = to.y - from.y, length = btSqrt(x * x + y * y);
        x_ = y / length;
        y_ = -x / length;
    }
    /// How far a point is to the right of it, m.
    btScalar beyond(btScalar x, btScalar y) const { return x_ * (x - from_.x) + y_ * (y - from_.y); }
    btScalar beyond(const Foot& foot) const { return beyond(foot.x, foot.y); }

  private:
    Foot from_;
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
    for (std::size_t left_out = 0; left_out < base.size(); ++left_out) {
        std::vector<Foot> triangle = base;
        if (base.size() == 4) triangle.erase(triangle.begin() + static_cast<long>(left_out));
        if (triangle.size() == 3 && isUnderCentre(triangle[0], triangle[1], triangle[2])) return true;
    }
    return false;
}

/// The lowest foot, one as far from it as can be, and one far to the side of the two where the centre is.
std::vector<Foot> wideTriangle(const std::vector<Foot>& feet, const Foot& lowest) {
    std::vector<Foot> base = {lowest};
    base.reserve(4);
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

/// The lowest foot and two more between which the way from it over the centre goes on furthest; nothing if
/// the centre is over no triangle. There is always one with the lowest if there is any.
std::vector<Foot> triangleUnderCentre(const std::vector<Foot>& feet, const Foot& lowest) {
    std::vector<Foot> best;
    btScalar furthest_way = 0;
    for (const Foot& second : feet)
        for (const Foot& third : feet) {
            if (!isUnderCentre(lowest, second, third)) continue;
            const btScalar x = third.x - second.x, y = third.y - second.y;
            const btScalar across = x * lowest.y - y * lowest.x;
            const btScalar ahead = x * (lowest.y - second.y) - y * (lowest.x - second.x);
            if (across == 0 || !(ahead / across > furthest_way)) continue;
            furthest_way = ahead / across;
            best = {lowest, second, third};
        }
    return best;
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
