#pragma once

namespace regarment {

/// Two sides of a garment that its pattern takes for alike.
enum class Sides { LeftRight, FrontBack };

}  // namespace regarment
