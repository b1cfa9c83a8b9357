package org.dronemap.core.operation;

import java.util.List;

/** A reason why a wish is not taken, as programs know it. Each kind of what is conducted has an enum of its own. */
public interface ObjectionCode {
    /** Small letters with hyphens, such as {@code operation-over}; it never changes. */
    String word();

    /** One line. */
    String meaning();

    /** A sentence that is told with it. */
    String example();

    /** What is told each time, beside what was to be changed. */
    List<Objection.Subject> subjects();
}
