/** Keys of all commands. */
import { Dialog } from "./Dialog.tsx";
import { written } from "./keys.ts";
import { commands } from "./panels.ts";
import { dialog } from "./window.ts";

export function Keys({ keys }: { keys: readonly string[] }) {
  return (
    <span class="keys">
      {keys.map((key) => (
        <span key={key}>
          {written(key).map((part) => (
            <kbd key={part}>{part}</kbd>
          ))}
        </span>
      ))}
    </span>
  );
}

export function Help() {
  const all = commands.value.filter((one) => one.keys?.length);
  const shown = all.filter((one, place) => all.findLastIndex((other) => other.title === one.title) === place);
  return (
    <Dialog label="Keys" close={() => (dialog.value = null)}>
      <h2>Keys</h2>
      <table class="key-table">
        <tbody>
          {shown.map((one) => (
            <tr key={one.id} class={one.when?.value === false ? "later" : ""}>
              <td>{one.title}</td>
              <td>
                <Keys keys={one.keys ?? []} />
              </td>
            </tr>
          ))}
        </tbody>
      </table>
      <p class="soft">Pale ones work once there is something for them to do. On a Mac, Ctrl is ⌘.</p>
      <form method="dialog">
        <button class="plain" autofocus>
          Close
        </button>
      </form>
    </Dialog>
  );
}
