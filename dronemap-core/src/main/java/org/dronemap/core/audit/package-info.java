/** What was done by whom: records in a chain that shows every later change of them. */
@NullMarked
package org.dronemap.core.audit;

import org.jspecify.annotations.NullMarked;
