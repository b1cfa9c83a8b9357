/** How fast telemetry is kept and found; run by hand. */
@NullMarked
package org.dronemap.store.bench;

import org.jspecify.annotations.NullMarked;
