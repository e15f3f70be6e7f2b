// An example of Bullet's browser, driven by a browser without a window.
#include "example_browser/fracture_example.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <limits>
#include <memory>
#include <set>

#include "example_browser/example_table.h"
#include "recording_browser.h"

namespace {

/// Memory that Bullet has now. Counts from its construction on.
class BulletMemory {
  public:
    BulletMemory() {
        btAlignedAllocSetCustom(
            [](std::size_t size) {
                ++blocks_;
                return std::malloc(size);
            },
            [](void* block) {
                blocks_ -= block != nullptr;
                std::free(block);
            });
    }
    ~BulletMemory() {
        btAlignedAllocSetCustom([](std::size_t size) { return std::malloc(size); },
                                [](void* block) { std::free(block); });
    }
    BulletMemory(const BulletMemory&) = delete;
    BulletMemory& operator=(const BulletMemory&) = delete;
    static long blocks() { return blocks_; }

  private:
    static inline std::atomic<long> blocks_{0};
};

/// The example of that name, as the browser makes it.
std::unique_ptr<demo::FractureExample> make(const std::string& name, RecordingBrowser& browser) {
    for (const demo::BrowserEntry& entry : demo::brittleFractureEntries()) {
        if (entry.name != name) continue;
        CommonExampleOptions options(&browser, entry.option);
        return std::unique_ptr<demo::FractureExample>(
            dynamic_cast<demo::FractureExample*>(entry.create(options)));
    }
    return nullptr;
}

void expectEveryBodyIsDrawnOnce(const demo::FractureExample& example, const RecordingBrowser& browser) {
    std::set<int> drawn;
    for (int i = 0; i < example.m_dynamicsWorld->getNumCollisionObjects(); ++i)
        drawn.insert(example.m_dynamicsWorld->getCollisionObjectArray()[i]->getUserIndex());
    EXPECT_EQ(drawn.size(), static_cast<std::size_t>(example.m_dynamicsWorld->getNumCollisionObjects()));
    EXPECT_EQ(drawn, browser.instances);
}

/// Steps until there are more bodies than at the start; false if that takes more than a second.
bool stepToABreak(demo::FractureExample& example) {
    const int bodies = example.m_dynamicsWorld->getNumCollisionObjects();
    for (int step = 0; step < 60 && example.m_dynamicsWorld->getNumCollisionObjects() <= bodies; ++step)
        example.stepSimulation(1.0f / 60);
    return example.m_dynamicsWorld->getNumCollisionObjects() > bodies;
}

TEST(ExampleTable, HasAHeadingAndEveryScene) {
    const std::vector<demo::BrowserEntry>& entries = demo::brittleFractureEntries();
    ASSERT_EQ(entries.size(), 7u);
    EXPECT_EQ(entries[0].name, "Brittle fracture");
    EXPECT_EQ(entries[0].create, nullptr);
    for (std::size_t i = 1; i < entries.size(); ++i) {
        EXPECT_EQ(entries[i].menu_level, 1);
        EXPECT_NE(entries[i].create, nullptr);
        EXPECT_FALSE(entries[i].description.empty());
    }
}

TEST(FractureExample, DrawsEveryBodyOnceBeforeAndAfterTheBreak) {
    RecordingBrowser browser;
    const auto example = make("Plaster wall", browser);
    ASSERT_TRUE(example);
    example->initPhysics();
    example->resetCamera();
    EXPECT_GT(browser.camera_distance, 0);
    EXPECT_EQ(browser.instances.size(), 3u) << "floor, wall and ball";
    expectEveryBodyIsDrawnOnce(*example, browser);
    ASSERT_TRUE(stepToABreak(*example));
    for (int step = 0; step < 20; ++step) {
        expectEveryBodyIsDrawnOnce(*example, browser);
        example->renderScene();
        example->stepSimulation(1.0f / 60);
    }
    example->exitPhysics();
    EXPECT_TRUE(browser.textures.empty());
}

TEST(FractureExample, StartsAgainTenTimesAndKeepsNoMemory) {
    const BulletMemory memory;
    {
        RecordingBrowser browser;
        const auto example = make("Plaster wall", browser);
        example->initPhysics();
        const int bodies = example->m_dynamicsWorld->getNumCollisionObjects();
        EXPECT_FALSE(browser.buttons.at(0).m_isTrigger) << "it would stay pressed";
        long blocks = 0;
        for (int round = 0; round < 10; ++round) {
            ASSERT_TRUE(stepToABreak(*example));
            browser.buttons.at(0).m_callback(0, true, browser.buttons.at(0).m_userPointer);
            example->stepSimulation(0);
            EXPECT_EQ(example->m_dynamicsWorld->getNumCollisionObjects(), bodies);
            expectEveryBodyIsDrawnOnce(*example, browser);
            EXPECT_EQ(browser.textures.size(), 1u);
            // The world keeps the room that it took for the first break.
            if (round == 0) blocks = BulletMemory::blocks();
            EXPECT_LE(BulletMemory::blocks(), blocks);
        }
        example->exitPhysics();
    }
    EXPECT_EQ(BulletMemory::blocks(), 0);
}

TEST(FractureExample, DrawsAllAnewWhereTheBrowserKeepsTooManyVertices) {
    RecordingBrowser browser;
    const auto example = make("Plaster wall", browser);
    example->initPhysics();
    ASSERT_TRUE(stepToABreak(*example));
    browser.capacity = browser.vertices_kept;  // of the wall and of its pieces, so the ball finds no room
    EXPECT_TRUE(example->keyboardCallback('.', 1));
    EXPECT_LT(browser.vertices_kept, browser.capacity) << "the vertices of the whole wall are let go";
    for (int step = 0; step < 5; ++step) {
        expectEveryBodyIsDrawnOnce(*example, browser);
        example->stepSimulation(1.0f / 60);
    }
    example->exitPhysics();
}

TEST(FractureExample, TriesOnceToDrawWhatTheBrowserHasNoRoomFor) {
    RecordingBrowser browser;
    const auto example = make("Coffee cup", browser);
    browser.capacity = 1000;
    example->initPhysics();
    EXPECT_EQ(browser.instances.size(), 1u) << "the floor";
    const int tries = browser.shape_tries;
    for (int step = 0; step < 5; ++step) example->stepSimulation(1.0f / 60);
    EXPECT_EQ(browser.shape_tries, tries);
    browser.capacity = std::numeric_limits<long>::max();
    example->restart();
    expectEveryBodyIsDrawnOnce(*example, browser);
    example->exitPhysics();
}

TEST(FractureExample, ShootsABallFromTheCamera) {
    RecordingBrowser browser;
    const auto example = make("Plaster wall", browser);
    example->initPhysics();
    const std::size_t drawn = browser.instances.size();
    EXPECT_TRUE(example->keyboardCallback('.', 1));
    EXPECT_TRUE(example->mouseButtonCallback(2, 1, 10, 10));
    EXPECT_EQ(browser.instances.size(), drawn + 2);
    expectEveryBodyIsDrawnOnce(*example, browser);
    example->exitPhysics();
}

TEST(FractureExample, LetsGoOfABodyThatBreaksInTheHand) {
    RecordingBrowser browser;
    const auto example = make("Plaster wall", browser);
    example->initPhysics();
    btRigidBody* wall = nullptr;
    for (int i = 0; i < example->m_dynamicsWorld->getNumCollisionObjects(); ++i) {
        btRigidBody* body = btRigidBody::upcast(example->m_dynamicsWorld->getCollisionObjectArray()[i]);
        if (body->getUserPointer()) wall = body;
    }
    ASSERT_NE(wall, nullptr);
    example->hold(wall);
    ASSERT_TRUE(stepToABreak(*example));
    EXPECT_EQ(example->m_pickedBody, nullptr);
    EXPECT_EQ(example->m_dynamicsWorld->getNumConstraints(), 0);
    example->exitPhysics();
}

TEST(FractureExample, SlidersChangeTheNextStart) {
    RecordingBrowser browser;
    const auto example = make("Plaster wall", browser);
    example->initPhysics();
    ASSERT_EQ(browser.sliders.size(), 4u);
    std::vector<btScalar> before;
    for (const SliderParams& slider : browser.sliders) before.push_back(*slider.m_paramValuePointer);
    *browser.sliders[0].m_paramValuePointer = browser.sliders[0].m_maxVal;  // strength
    *browser.sliders[2].m_paramValuePointer = browser.sliders[2].m_minVal;  // of a slow ball
    example->restart();
    EXPECT_FALSE(stepToABreak(*example));
    for (std::size_t i = 0; i < before.size(); ++i) *browser.sliders[i].m_paramValuePointer = before[i];
    *browser.sliders[1].m_paramValuePointer = 5;  // fragments
    *browser.sliders[3].m_paramValuePointer = 0;  // quality
    example->restart();
    EXPECT_TRUE(stepToABreak(*example));
    EXPECT_LT(browser.instances.size(), 20u);
    for (std::size_t i = 0; i < before.size(); ++i) *browser.sliders[i].m_paramValuePointer = before[i];
    example->exitPhysics();
}

}  // namespace
