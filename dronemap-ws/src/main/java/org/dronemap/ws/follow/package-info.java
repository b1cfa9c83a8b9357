/**
 * Following a phone.
 *
 * <p>Enters: use cases about follows.
 *
 * <p>Never: where the drone is led: that is cognitive.
 */
@NullMarked
package org.dronemap.ws.follow;

import org.jspecify.annotations.NullMarked;
