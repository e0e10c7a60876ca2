// SPDX-License-Identifier: Apache-2.0
#include "commands/starter_configs.h"

namespace hexweave {

const std::array<StarterConfig, 4> starter_configs{
    {{"airfoil", "a C-grid around a NACA section", starters::airfoil_yaml},
     {"channel", "a face over a hump", starters::channel_yaml},
     {"pipe", "five blocks", starters::pipe_yaml},
     {"wing", "four blocks around a swept wing, of a component used twice", starters::wing_yaml}}};

}  // namespace hexweave
