/** Who may call an operation of REST, what it costs and what record it leaves, as each handler says. */
@NullMarked
package org.dronemap.ws.access;

import org.jspecify.annotations.NullMarked;
