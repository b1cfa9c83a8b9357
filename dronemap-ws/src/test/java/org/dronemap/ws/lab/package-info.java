/** The flight laboratory: a whole server and vehicles on wires of memory, in one thread and in stepped time. */
@NullMarked
package org.dronemap.ws.lab;

import org.jspecify.annotations.NullMarked;
