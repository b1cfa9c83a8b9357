/** What a drone is now: identity, immutable state whose facts may be unknown, capabilities. */
@NullMarked
package org.dronemap.core.drone;

import org.jspecify.annotations.NullMarked;
