#pragma once

#include <sherd/breakable_asset.h>
#include <sherd/enum_names.h>
#include <sherd/events.h>
#include <sherd/fields.h>
#include <sherd/fracture_world.h>
#include <sherd/material.h>
#include <sherd/result.h>
#include <sherd/settings.h>
#include <sherd/strength_field.h>
#include <sherd/stress_field.h>
#include <sherd/stress_model.h>
#include <sherd/surface_region.h>
#include <sherd/triangle_mesh.h>
#include <sherd/types.h>
