/** Signatures of MAVLink 2 frames: keys, timestamps, signing what goes out and judging what comes in; pure. */
@NullMarked
package org.dronemap.mavlink.signing;

import org.jspecify.annotations.NullMarked;
