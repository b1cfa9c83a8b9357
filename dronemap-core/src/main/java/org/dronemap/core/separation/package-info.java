/**
 * Keeps drones apart: where each may be in the next seconds, who gives way to whom, and what is proved clear before
 * anything is sent. Pure: who drives it is {@code core.conduct}. One mechanism for all that flies, whoever leads it.
 */
@NullMarked
package org.dronemap.core.separation;

import org.jspecify.annotations.NullMarked;
