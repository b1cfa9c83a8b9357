/**
 * Recordings of what vehicles and server said, and playing them back.
 *
 * <p>Enters: use cases about recordings.
 *
 * <p>Never: writing them: that is the proxy.
 */
@NullMarked
package org.dronemap.ws.recording;

import org.jspecify.annotations.NullMarked;
