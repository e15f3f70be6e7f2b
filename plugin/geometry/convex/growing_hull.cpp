#include "geometry/convex/growing_hull.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/numerics/mesh_measures.h"
#include "geometry/convex/point_columns.h"

namespace sherd {

namespace {

constexpr double relative_rounding = 1e-6;  // of the diagonal of the box
// Of a face, in what is rounded: the normal of a lower one is off by as much as rounding is of its height.
constexpr float least_height = 100;
constexpr float least_thickness = 2 * least_height;  // of the points: with less, sides are such faces
constexpr std::size_t usual_faces = 128;
constexpr float one_plane = 1e-4f;  // angle between faces that lie in one plane, but for rounding

/// The point for which a measure is largest.
template <class Measure>
int furthestOf(const std::vector<int>& points, const Measure& measure) {
    return *std::max_element(points.begin(), points.end(),
                             [&](int p, int q) { return measure(p) < measure(q); });
}

}  // namespace

GrowingHull::GrowingHull(const std::vector<Vec3>& points)
    : x_(points.size()), y_(points.size()), z_(points.size()) {
    if (points.empty()) return;
    const Eigen::AlignedBox3d box = boundingBox(points);
    const Vec3 middle = box.center();
    rounding_ = static_cast<float>(relative_rounding * box.diagonal().norm());
    tolerance_ = rounding_;
    for (std::size_t p = 0; p < points.size(); ++p) {
        x_[p] = static_cast<float>(points[p][0] - middle[0]);
        y_[p] = static_cast<float>(points[p][1] - middle[1]);
        z_[p] = static_cast<float>(points[p][2] - middle[2]);
    }
    const std::vector<int> outermost = outermostIn(box.sizes());
    const std::vector<int> corners = firstCorners(outermost);
    if (corners.empty()) return;
    faces_.reserve(usual_faces);
    side_at_.assign(points.size(), -1);
    next_.assign(points.size(), -1);
    makeFirstFaces(corners);
    for (const int p : outermost) takeUp(p);
    shareOut();
    addUpTo(static_cast<int>(points.size()));
}

/// In 26 directions to the sides, edges and corners of the box, each once.
std::vector<int> GrowingHull::outermostIn(const Vec3& box_sizes) const {
    std::vector<int> found;
    std::vector<float> reach(x_.size());
    const auto count = static_cast<long>(x_.size());
    const Vec3 stretch = box_sizes.array().max(1e-30).inverse();
    for (int d = 14; d < 27; ++d) {  // of 3 x 3 x 3, one of each opposite two
        const Eigen::Vector3f way =
            Vec3(d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1).cwiseProduct(stretch).cast<float>();
        findReach(x_.data(), y_.data(), z_.data(), x_.size(), way.data(), reach.data());
        float highest, lowest;
        findExtremes(reach.data(), count, &highest, &lowest);
        found.push_back(firstPlace(reach.data(), count, highest));
        found.push_back(firstPlace(reach.data(), count, lowest));
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

/// Of a large tetrahedron; none of points in a plane, or nearly so.
std::vector<int> GrowingHull::firstCorners(const std::vector<int>& points) const {
    const Vec3 any = at(points.front());
    const int first = furthestOf(points, [&](int p) { return (at(p) - any).squaredNorm(); });
    const Vec3 a = at(first);
    const int b = furthestOf(points, [&](int p) { return (at(p) - a).squaredNorm(); });
    const Vec3 way = (at(b) - a).normalized();
    const auto fromLine = [&](int p) { return way.cross(at(p) - a).norm(); };
    const int c = furthestOf(points, fromLine);
    if (!(fromLine(c) > least_thickness * rounding_)) return {};
    const Vec3 normal = (at(b) - a).cross(at(c) - a).normalized();
    const auto above = [&](int p) { return normal.dot(at(p) - a); };
    const int d = furthestOf(points, [&](int p) { return std::abs(above(p)); });
    if (!(std::abs(above(d)) > least_thickness * rounding_)) return {};
    if (above(d) > 0) return {first, c, b, d};
    return {first, b, c, d};
}

/// The first three corners are seen from outside, anticlockwise.
void GrowingHull::makeFirstFaces(const std::vector<int>& corners) {
    const int a = corners[0], b = corners[1], c = corners[2], d = corners[3];
    makeFace(a, b, c);
    makeFace(b, a, d);
    makeFace(c, b, d);
    makeFace(a, c, d);
    faces_[0].neighbours = {1, 2, 3};
    faces_[1].neighbours = {0, 3, 2};
    faces_[2].neighbours = {0, 1, 3};
    faces_[3].neighbours = {0, 2, 1};
    new_faces_ = {0, 1, 2, 3};
    vertex_count_ = 4;
}

int GrowingHull::makeFace(int a, int b, int c) {
    int place = static_cast<int>(faces_.size());
    if (free_.empty()) {
        faces_.emplace_back();
        is_seen_.push_back(0);
    } else {
        place = free_.back();
        free_.pop_back();
    }
    const Vec3 side = at(b) - at(a), other = at(c) - at(a), area = side.cross(other);
    const double length = area.norm();
    Face face;
    face.corners = {a, b, c};
    const double least = least_height * rounding_;
    if (length * length > least * least * std::max(side.squaredNorm(), other.squaredNorm())) {
        const Vec3 normal = area / length;
        face.normal = normal.cast<float>();
        face.height = static_cast<float>(normal.dot(at(a)));
    }
    faces_[place] = face;
    return place;
}

/// A face without an area goes with those around it, if `slivers` are to.
bool GrowingHull::isSeen(int face, int point, bool slivers) const {
    const Face& f = faces_[face];
    return f.normal.isZero(0)
               ? slivers
               : f.normal.dot(Eigen::Vector3f(x_[point], y_[point], z_[point])) - f.height > rounding_;
}

/// The faces around `face` that a point is outside of, as far as they are connected.
void GrowingHull::findSeen(int point, int face, bool slivers) {
    seen_.assign(1, face);
    is_seen_[face] = 1;
    for (std::size_t i = 0; i < seen_.size(); ++i)
        for (const int next : faces_[seen_[i]].neighbours) {
            if (is_seen_[next] || !isSeen(next, point, slivers)) continue;
            is_seen_[next] = 1;
            seen_.push_back(next);
        }
}

/// Around the faces that are seen, in order. Whether they are one closed line, as they are but for rounding.
bool GrowingHull::findSides() {
    sides_.clear();
    for (const int face : seen_)
        for (int i = 0; i < 3; ++i) {
            const int beyond = faces_[face].neighbours[i];
            if (is_seen_[beyond]) continue;
            const auto& around = faces_[beyond].neighbours;
            const int place =
                static_cast<int>(std::find(around.begin(), around.end(), face) - around.begin());
            sides_.push_back({faces_[face].corners[i], faces_[face].corners[(i + 1) % 3], beyond, place});
        }
    bool is_simple = sides_.size() >= 3;
    for (std::size_t s = 0; s < sides_.size(); ++s) {
        is_simple = is_simple && side_at_[sides_[s].from] < 0;
        side_at_[sides_[s].from] = static_cast<int>(s);
    }
    ordered_.clear();
    for (int s = 0; is_simple && ordered_.size() < sides_.size(); s = side_at_[sides_[s].to]) {
        is_simple = s > 0 || (s == 0 && ordered_.empty());
        if (!is_simple) break;
        ordered_.push_back(sides_[s]);
    }
    for (const Side& side : sides_) side_at_[side.from] = -1;
    std::swap(sides_, ordered_);
    return is_simple;
}

void GrowingHull::replaceSeen(int point) {
    for (const int face : seen_) {
        faces_[face].is_there = false;
        for (int p = faces_[face].first; p >= 0; p = next_[p])
            if (p != point) takeUp(p);
        free_.push_back(face);
    }
    new_faces_.clear();
    for (const Side& side : sides_) {
        const int face = makeFace(side.from, side.to, point);
        faces_[side.beyond].neighbours[side.place] = face;
        faces_[face].neighbours[0] = side.beyond;
        new_faces_.push_back(face);
    }
    const std::size_t count = new_faces_.size();
    for (std::size_t i = 0; i < count; ++i) {
        faces_[new_faces_[i]].neighbours[1] = new_faces_[(i + 1) % count];
        faces_[new_faces_[i]].neighbours[2] = new_faces_[(i + count - 1) % count];
    }
    // What a face was given may lie outside one that stays as well.
    for (const Side& side : sides_) new_faces_.push_back(side.beyond);
    shareOut();
}

bool GrowingHull::add(int point, int face) {
    // A face without an area may join faces that have nothing else in common.
    for (const bool slivers : {true, false}) {
        findSeen(point, face, slivers);
        const bool is_simple = findSides();
        for (const int seen : seen_) is_seen_[seen] = 0;
        if (!is_simple) continue;
        replaceSeen(point);
        return true;
    }
    return false;
}

void GrowingHull::takeUp(int point) {
    points_.x.push_back(x_[point]);
    points_.y.push_back(y_[point]);
    points_.z.push_back(z_[point]);
    points_.which.push_back(point);
}

/// Among the faces that may have one outside. What none of them has is inside from now on.
void GrowingHull::shareOut() {
    const std::size_t count = points_.which.size();
    points_.distance.assign(count, tolerance_);
    points_.face.assign(count, -1);
    for (const int face : new_faces_)
        giveWhereFurther(points_.x.data(), points_.y.data(), points_.z.data(), count,
                         faces_[face].normal.data(), faces_[face].height, face, points_.distance.data(),
                         points_.face.data());
    for (std::size_t p = 0; p < count; ++p) {
        if (points_.face[p] < 0) continue;
        Face& face = faces_[points_.face[p]];
        next_[points_.which[p]] = std::exchange(face.first, points_.which[p]);
        if (points_.distance[p] <= face.distance) continue;
        face.distance = points_.distance[p];
        face.furthest = points_.which[p];
    }
    for (auto* numbers : {&points_.x, &points_.y, &points_.z}) numbers->clear();
    points_.which.clear();
}

/// -1 if no face has a point outside.
int GrowingHull::highestFace() const {
    int highest = -1;
    float distance = 0;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        if (!faces_[f].is_there || faces_[f].distance <= distance) continue;
        distance = faces_[f].distance;
        highest = static_cast<int>(f);
    }
    return highest;
}

void GrowingHull::addUpTo(int most_vertices) {
    while (vertex_count_ < most_vertices) {
        const int highest = highestFace();
        if (highest < 0) break;
        Face& face = faces_[highest];
        if (add(face.furthest, highest)) {
            ++vertex_count_;
            continue;
        }
        left_out_ = std::max(left_out_, face.distance);
        face.distance = 0;
    }
}

void GrowingHull::growTo(int most_vertices, double tolerance_m) {
    if (isFlat()) return;
    tolerance_ = std::max(static_cast<float>(tolerance_m), rounding_);
    points_.x = x_;
    points_.y = y_;
    points_.z = z_;
    points_.which.resize(x_.size());
    std::iota(points_.which.begin(), points_.which.end(), 0);
    new_faces_.clear();
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        faces_[f].first = faces_[f].furthest = -1;  // with points that could not be added
        faces_[f].distance = 0;
        if (faces_[f].is_there) new_faces_.push_back(static_cast<int>(f));
    }
    shareOut();
    addUpTo(most_vertices);
}

/// Not those inside a face or on an edge: their faces lie in no more than two planes.
std::vector<int> GrowingHull::vertices() const {
    struct Corner {
        int planes = 0;
        std::array<const Face*, 2> in_them{};
    };
    std::vector<int> place(x_.size(), -1), found;
    std::vector<Corner> corners;
    for (const Face& face : faces_) {
        if (!face.is_there || face.normal.isZero(0)) continue;
        for (const int point : face.corners) {
            if (place[point] < 0) {
                place[point] = static_cast<int>(corners.size());
                corners.emplace_back();
            }
            Corner& corner = corners[place[point]];
            const auto known =
                std::any_of(corner.in_them.begin(), corner.in_them.begin() + std::min(corner.planes, 2),
                            [&](const Face* other) {
                                return (face.normal - other->normal).squaredNorm() < one_plane * one_plane;
                            });
            if (known || corner.planes == 3) continue;
            if (corner.planes < 2) corner.in_them[corner.planes] = &face;
            if (++corner.planes == 3) found.push_back(point);
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

double GrowingHull::volume() const {
    double six_volumes = 0;
    for (const Face& face : faces_)
        if (face.is_there)
            six_volumes += at(face.corners[0]).cross(at(face.corners[1])).dot(at(face.corners[2]));
    return std::max(six_volumes / 6, 0.0);
}

double GrowingHull::outside() const {
    float furthest = left_out_;
    for (const Face& face : faces_)
        if (face.is_there) furthest = std::max(furthest, face.distance);
    return furthest;
}

}  // namespace sherd
