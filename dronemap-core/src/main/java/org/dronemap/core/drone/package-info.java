/**
 * What a drone is now: identity, immutable state whose facts may be unknown, capabilities.
 *
 * <p>Enters: a fact about a drone, which may be unknown.
 *
 * <p>Never: where it came from.
 */
@NullMarked
package org.dronemap.core.drone;

import org.jspecify.annotations.NullMarked;
