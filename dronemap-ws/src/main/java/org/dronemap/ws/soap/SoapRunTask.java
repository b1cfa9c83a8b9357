package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlType;
import org.dronemap.ws.service.RunView;
import org.jspecify.annotations.Nullable;

/** What became of one task of a waypoint; {@code type} and {@code result} as in REST. */
@SuppressWarnings("UnusedVariable") // JAXB reads the fields
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "runTask",
        namespace = Namespace.URI,
        propOrder = {"type", "result", "droneId", "photo", "words"})
public class SoapRunTask {
    private String type = "";
    private String result = "";
    private @Nullable String droneId;
    private @Nullable Integer photo;
    private @Nullable String words;

    static SoapRunTask of(RunView.TaskView view) {
        SoapRunTask task = new SoapRunTask();
        task.type = view.type();
        task.result = view.result();
        task.droneId = view.drone();
        task.photo = view.photo();
        task.words = view.words();
        return task;
    }
}
