/** Ends of processes of this server that nobody had stopped, and how carefully the next one starts. */
@NullMarked
package org.dronemap.core.process;

import org.jspecify.annotations.NullMarked;
