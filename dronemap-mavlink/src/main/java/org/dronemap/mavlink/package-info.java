/** MAVLink 1 and 2 frames: reading, checking and writing; pure, bytes in and out. */
@NullMarked
package org.dronemap.mavlink;

import org.jspecify.annotations.NullMarked;
