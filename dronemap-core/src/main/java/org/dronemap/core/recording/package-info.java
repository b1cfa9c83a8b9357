/** Recordings of what vehicles said and were told: what is known of each, and where that is kept. */
@NullMarked
package org.dronemap.core.recording;

import org.jspecify.annotations.NullMarked;
