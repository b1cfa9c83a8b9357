/**
 * Keys that robots prove themselves with.
 *
 * <p>Enters: use cases about these keys.
 *
 * <p>Never: the wire of robots.
 */
@NullMarked
package org.dronemap.ws.robotkey;

import org.jspecify.annotations.NullMarked;
