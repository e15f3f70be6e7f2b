#include "bullet/fragments/birth_callback.h"

#include <exception>

#include "bullet/world/step_phase.h"
#include "fracture/add_sentence.h"

namespace sherd {

namespace {

/// The callback, and then the place that the motion state is to start from. The extension pointer, by which
/// the body is known, stays, and no body is without a shape.
void callAndPlace(const FragmentCallback& callback, FragmentBirth& birth) {
    const btTransform place = birth.body.getWorldTransform(), drawn = renderedTransform(birth.body);
    void* const token = birth.body.internalGetExtensionPointer();
    btCollisionShape* const shape = birth.body.getCollisionShape();
    const auto putBack = [&] {
        // Bullet's setMotionState moves a body to where the motion state says.
        birth.body.setWorldTransform(place);
        birth.body.setInterpolationWorldTransform(place);
        birth.body.updateInertiaTensor();
        birth.body.internalSetExtensionPointer(token);
        if (!birth.body.getCollisionShape()) birth.body.setCollisionShape(shape);
    };
    try {
        callback(birth);
        if (birth.body.getMotionState()) birth.body.getMotionState()->setWorldTransform(drawn);
    } catch (...) {
        putBack();
        throw;
    }
    putBack();
}

}  // namespace

void announceBirth(btDiscreteDynamicsWorld& world, const FragmentCallback& callback, const Breakable& parent,
                   Breakable& fragment, BlowEvent& event) {
    const NoStepMeanwhile guard(world);
    FragmentBirth birth{*fragment.body, fragment.asset,        *parent.body,        event,
                        fragment.name,  fragment.filter.group, fragment.filter.mask};
    const std::string rest = "; the fragment entered the world as it was by then.";
    try {
        callAndPlace(callback, birth);
    } catch (const std::exception& trouble) {
        addSentence(event.message,
                    std::string("The fragment callback threw (") + trouble.what() + ")" + rest);
    } catch (...) {
        addSentence(event.message, "The fragment callback threw what is no std::exception" + rest);
    }
}

}  // namespace sherd
