// What the changes of one movement of the hand have in common, and no others: of other loads
// of the page neither.
const page = Date.now().toString(36);
let count = 0;

export const newGesture = (): string => `${page} ${++count}`;
