/** The composition root: the only place that constructs across modules. */
@NullMarked
package org.dronemap.ws.wiring;

import org.jspecify.annotations.NullMarked;
