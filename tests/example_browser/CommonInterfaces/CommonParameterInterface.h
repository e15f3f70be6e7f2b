#pragma once

#include <LinearMath/btScalar.h>

struct SliderParams {
    SliderParams(const char* name, btScalar* value) : m_name(name), m_paramValuePointer(value) {}
    const char* m_name;
    float m_minVal = -100, m_maxVal = 100;
    btScalar* m_paramValuePointer;
    bool m_clampToIntegers = false;
};

struct ButtonParams {
    ButtonParams(const char* name, int button, bool is_trigger)
        : m_name(name), m_buttonId(button), m_isTrigger(is_trigger) {}
    const char* m_name;
    int m_buttonId;
    void* m_userPointer = nullptr;
    bool m_isTrigger;
    void (*m_callback)(int button, bool state, void* user_pointer) = nullptr;
};

struct CommonParameterInterface {
    virtual ~CommonParameterInterface() = default;
    virtual void registerSliderFloatParameter(SliderParams& slider) = 0;
    virtual void registerButtonParameter(ButtonParams& button) = 0;
};
