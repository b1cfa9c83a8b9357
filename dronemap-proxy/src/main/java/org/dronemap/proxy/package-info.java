/**
 * Links to vehicles: bytes to events, commands to bytes; {@code Proxy} is the one door.
 *
 * <p>Enters: what is built from all rooms below.
 *
 * <p>Never: frames.
 */
@NullMarked
package org.dronemap.proxy;

import org.jspecify.annotations.NullMarked;
