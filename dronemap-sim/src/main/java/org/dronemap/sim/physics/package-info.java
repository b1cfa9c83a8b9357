/** How a multicopter moves, is blown about and runs out of energy: pure state, stepped by its owner, metres and seconds. */
@NullMarked
package org.dronemap.sim.physics;

import org.jspecify.annotations.NullMarked;
