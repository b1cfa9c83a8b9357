/** What is known of processes of this server that ended without being stopped, and how carefully the next one starts. */
@NullMarked
package org.dronemap.core.process;

import org.jspecify.annotations.NullMarked;
