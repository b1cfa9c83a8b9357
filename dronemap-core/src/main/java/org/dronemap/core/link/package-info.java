/**
 * Links to vehicles that people set up: where they are, and the keys that vehicles prove themselves with.
 *
 * <p>Enters: a fact about a link, and the port that keeps it.
 *
 * <p>Never: sockets.
 */
@NullMarked
package org.dronemap.core.link;

import org.jspecify.annotations.NullMarked;
