#include "example_browser/body_graphics.h"

#include <CommonInterfaces/CommonGUIHelperInterface.h>
#include <CommonInterfaces/CommonRenderInterface.h>

#include <algorithm>
#include <cmath>

#include "film/drawn_mesh.h"

namespace demo {
namespace {

constexpr int no_instance = -1;
constexpr int texture_width =
    8;  ///< the left half has the colour of the outside, the right half that of cracks
constexpr int floats_per_vertex = 9;  ///< x, y, z, w, normal, texture coordinates

unsigned char toByte(double linear) {
    return static_cast<unsigned char>(std::lround(255 * std::pow(std::clamp(linear, 0.0, 1.0), 1 / 2.2)));
}

std::vector<unsigned char> texelsOf(const Look& look) {
    std::vector<unsigned char> texels;
    for (int row = 0; row < texture_width; ++row) {
        for (int column = 0; column < texture_width; ++column) {
            const Vec3& colour = column < texture_width / 2 ? look.outside : look.crack;
            for (int channel = 0; channel < 3; ++channel) texels.push_back(toByte(colour[channel]));
        }
    }
    return texels;
}

void append(std::vector<float>& floats, const btVector3& v) {
    for (int axis = 0; axis < 3; ++axis) floats.push_back(v[axis]);
}

btVector3 toBullet(const Vec3& v) {
    return btVector3(btScalar(v.x()), btScalar(v.y()), btScalar(v.z()));
}

/// In the frame of the body, whose origin is its centre of mass.
std::vector<float> verticesOf(const DrawnMesh& mesh, const btTransform& to_body) {
    std::vector<float> floats;
    floats.reserve(mesh.vertices.size() * floats_per_vertex);
    for (const DrawnVertex& vertex : mesh.vertices) {
        append(floats, to_body * toBullet(vertex.position));
        floats.push_back(1);
        append(floats, to_body.getBasis() * toBullet(vertex.normal));
        floats.push_back(vertex.kind == sherd::SurfaceKind::crack ? 0.75f : 0.25f);
        floats.push_back(0.5f);
    }
    return floats;
}

std::vector<int> indicesOf(const DrawnMesh& mesh) {
    std::vector<int> indices(mesh.outside.begin(), mesh.outside.end());
    indices.insert(indices.end(), mesh.crack.begin(), mesh.crack.end());
    return indices;
}

}  // namespace

BodyGraphics::~BodyGraphics() {
    for (const auto& [colours, texture] : textures_) helper_.removeTexture(texture);
}

void BodyGraphics::watch(PlacedScene& scene) {
    scene.fracture().onFragment([](sherd::FragmentBirth& birth) { birth.body.setUserIndex(no_instance); });
}

void BodyGraphics::addMissing(btDiscreteDynamicsWorld& world, const PlacedScene& scene) {
    if (is_full_ || tryToAddMissing(world, scene)) return;
    forgetAll(world);
    is_full_ = !tryToAddMissing(world, scene);
}

/// False at the first body that the browser has no room for: it would keep a record of each further try.
bool BodyGraphics::tryToAddMissing(btDiscreteDynamicsWorld& world, const PlacedScene& scene) {
    for (int i = 0; i < world.getNumCollisionObjects(); ++i) {
        btRigidBody* body = btRigidBody::upcast(world.getCollisionObjectArray()[i]);
        if (!body || body->getUserIndex() != no_instance) continue;
        if (scene.fracture().asset(body))
            addBreakable(*body, scene);
        else
            addPlain(*body);
        if (body->getUserIndex() == no_instance) return false;
    }
    return true;
}

void BodyGraphics::forgetAll(btDiscreteDynamicsWorld& world) {
    removeAll();
    for (int i = 0; i < world.getNumCollisionObjects(); ++i) {
        btCollisionObject* body = world.getCollisionObjectArray()[i];
        body->setUserIndex(no_instance);
        body->getCollisionShape()->setUserIndex(no_instance);  // the browser's number of its vertices
    }
}

void BodyGraphics::addBreakable(btRigidBody& body, const PlacedScene& scene) {
    const btTransform place = body.getWorldTransform();
    const DrawnMesh mesh = drawnMesh(scene.fracture().asset(&body)->surface());
    const std::vector<float> vertices =
        verticesOf(mesh, place.inverse() * scene.fracture().assetTransform(&body));
    const std::vector<int> indices = indicesOf(mesh);
    const int shape = helper_.registerGraphicsShape(vertices.data(), static_cast<int>(mesh.vertices.size()),
                                                    indices.data(), static_cast<int>(indices.size()),
                                                    B3_GL_TRIANGLES, textureOf(scene.lookOf(body)));
    if (shape < 0) return;  // the browser has no room for more vertices
    const float white[4] = {1, 1, 1, 1}, scaling[4] = {1, 1, 1, 1};
    const btQuaternion turn = place.getRotation();
    body.setUserIndex(helper_.registerGraphicsInstance(shape, place.getOrigin(), turn, white, scaling));
}

void BodyGraphics::addPlain(btRigidBody& body) {
    const btVector4 grey(0.8f, 0.8f, 0.78f, 1),
        steel(0.35f, 0.37f, 0.42f, 1);  // the browser reads opacity, too
    helper_.createCollisionShapeGraphicsObject(body.getCollisionShape());
    helper_.createRigidBodyGraphicsObject(&body, body.isStaticObject() ? grey : steel);
}

void BodyGraphics::remove(btRigidBody& body) {
    if (body.getUserIndex() == no_instance) return;
    helper_.removeGraphicsInstance(body.getUserIndex());
    body.setUserIndex(no_instance);
    is_full_ = false;
}

void BodyGraphics::removeAll() {
    helper_.removeAllGraphicsInstances();
    is_full_ = false;
}

int BodyGraphics::textureOf(const Look& look) {
    const auto key = std::make_tuple(look.outside.x(), look.outside.y(), look.outside.z(), look.crack.x(),
                                     look.crack.y(), look.crack.z());
    const auto [found, is_new] = textures_.try_emplace(key, no_instance);
    if (is_new) {
        found->second = helper_.registerTexture(texelsOf(look).data(), texture_width, texture_width);
    }
    return found->second;
}

}  // namespace demo
