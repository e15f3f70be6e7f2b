#pragma once

enum { B3_GL_TRIANGLES = 1 };

struct CommonCameraInterface {
    virtual ~CommonCameraInterface() = default;
    virtual void getCameraPosition(float position[3]) const = 0;
    virtual void getCameraTargetPosition(float position[3]) const = 0;
};

struct CommonRenderInterface {
    virtual ~CommonRenderInterface() = default;
    virtual CommonCameraInterface* getActiveCamera() = 0;
};
