/** What is remembered of drones: their states over time, what happened, and each flight; read long after, kept by rules. */
@NullMarked
package org.dronemap.core.history;

import org.jspecify.annotations.NullMarked;
