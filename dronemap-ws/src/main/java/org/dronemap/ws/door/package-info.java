/** A page by plain HTTP on which phones learn to trust this server, and nothing else. */
@NullMarked
package org.dronemap.ws.door;

import org.jspecify.annotations.NullMarked;
