/**
 * Who may call a handler, what it costs, and which record it leaves.
 *
 * <p>Enters: what is decided for every operation alike.
 *
 * <p>Never: a single feature.
 */
@NullMarked
package org.dronemap.ws.access;

import org.jspecify.annotations.NullMarked;
