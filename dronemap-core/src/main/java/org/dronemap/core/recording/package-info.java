/**
 * Recordings of what vehicles said and were told: what is known of each, and where that is kept.
 *
 * <p>Enters: a fact about a recording.
 *
 * <p>Never: frames.
 */
@NullMarked
package org.dronemap.core.recording;

import org.jspecify.annotations.NullMarked;
