/**
 * MAVLink 1 and 2 frames: reading, checking and writing; pure, bytes in and out.
 *
 * <p>Enters: what every frame has.
 *
 * <p>Never: sessions and vehicles.
 */
@NullMarked
package org.dronemap.mavlink;

import org.jspecify.annotations.NullMarked;
