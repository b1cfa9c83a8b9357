/** What may be asked of a drone, and the one outcome that every command ends in. */
@NullMarked
package org.dronemap.core.command;

import org.jspecify.annotations.NullMarked;
