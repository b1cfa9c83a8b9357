@NullMarked
package org.dronemap.sim.robot;

import org.jspecify.annotations.NullMarked;
