@NullMarked
package org.dronemap.cognitive.operation.run;

import org.jspecify.annotations.NullMarked;
