/** The operations of REST and their rules, as each handler says them. */
@NullMarked
package org.dronemap.ws.access;

import org.jspecify.annotations.NullMarked;
