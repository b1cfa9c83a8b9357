/** Virtual drones: what users hold instead of a drone, and which drone serves them when and why. */
@NullMarked
package org.dronemap.core.virtual;

import org.jspecify.annotations.NullMarked;
