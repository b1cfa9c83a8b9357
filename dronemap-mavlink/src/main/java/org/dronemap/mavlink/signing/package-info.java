/**
 * Signatures of MAVLink 2 frames: keys, timestamps, signing what goes out and judging what comes in; pure.
 *
 * <p>Enters: what a signature needs.
 *
 * <p>Never: where keys are kept.
 */
@NullMarked
package org.dronemap.mavlink.signing;

import org.jspecify.annotations.NullMarked;
